// markup.cpp - texts and bytes as parts of HTML and SVG.
#include "bench/markup.h"

#include <algorithm>
#include <array>

namespace firsthit::cli::bench {

namespace {

constexpr const char* kReplacement = "\xEF\xBF\xBD"; // U+FFFD

/// Bytes of the UTF-8 character that begins the text and that XML allows; 0 where there is none.
std::size_t character_length(std::string_view text)
{
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    const unsigned first = byte(0);
    if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' || first == '\r';
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
    std::uint32_t code = first & (0x7Fu >> length);
    for (std::size_t k = 1; k < length; ++k) {
        if ((byte(k) & 0xC0) != 0x80) return 0;
        code = code << 6 | (byte(k) & 0x3F);
    }
    constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = 0xD800 <= code && code <= 0xDFFF;
    const bool allowed = code >= kLeast[length] && code <= 0x10FFFF && !surrogate &&
                         code != 0xFFFE && code != 0xFFFF;
    return allowed ? length : 0;
}

} // namespace

std::string escaped(std::string_view text)
{
    std::string result;
    for (std::size_t k = 0; k < text.size();) {
        const std::size_t length = character_length(text.substr(k));
        const std::string_view character = text.substr(k, std::max<std::size_t>(1, length));
        k += character.size();
        if (length == 0)
            result += kReplacement;
        else if (character == "&")
            result += "&amp;";
        else if (character == "<")
            result += "&lt;";
        else if (character == ">")
            result += "&gt;";
        else if (character == "\"")
            result += "&quot;";
        else if (character == "'")
            result += "&#39;";
        else
            result += character;
    }
    return result;
}

std::string base64(std::span<const std::uint8_t> bytes)
{
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - k);
        std::uint32_t group = std::uint32_t(bytes[k]) << 16;
        if (count > 1) group |= std::uint32_t(bytes[k + 1]) << 8;
        if (count > 2) group |= bytes[k + 2];
        for (std::size_t digit = 0; digit < 4; ++digit)
            text += digit <= count ? kDigits[group >> (18 - 6 * digit) & 63] : '=';
    }
    return text;
}

} // namespace firsthit::cli::bench
