// uri.cpp - decodes data URIs and names of files.
#include "readers/gltf/data/uri.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <system_error>

namespace firsthit::gltf {
namespace {

constexpr std::uint8_t kNoDigit = 0xFF;

constexpr std::array<std::uint8_t, 256> base64_values()
{
    std::array<std::uint8_t, 256> values{};
    for (std::uint8_t& value : values) value = kNoDigit;
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t k = 0; k < kDigits.size(); ++k)
        values[static_cast<unsigned char>(kDigits[k])] = static_cast<std::uint8_t>(k);
    // The alphabet for URLs (RFC 4648, section 5) is used by some writers.
    values['-'] = 62;
    values['_'] = 63;
    return values;
}

std::optional<std::string> decode_base64(std::string_view text)
{
    static constexpr std::array<std::uint8_t, 256> kValue = base64_values();
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    if (text.size() % 4 == 1) return std::nullopt;
    std::string bytes(text.size() / 4 * 3 + text.size() % 4 * 3 / 4, '\0');
    std::size_t out = 0;
    for (std::size_t at = 0; at < text.size(); at += 4) {
        const std::size_t digits = std::min<std::size_t>(4, text.size() - at);
        std::uint32_t group = 0;
        std::uint32_t wrong = 0;
        for (std::size_t k = 0; k < digits; ++k) {
            const std::uint8_t value = kValue[static_cast<unsigned char>(text[at + k])];
            wrong |= value & 0xC0u;
            group |= std::uint32_t(value & 0x3Fu) << (18 - 6 * k);
        }
        if (wrong != 0) return std::nullopt;
        for (std::size_t k = 0; k + 1 < digits; ++k)
            bytes[out++] = static_cast<char>((group >> (16 - 8 * k)) & 0xFF);
    }
    return bytes;
}

int hex_digit(char c)
{
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

} // namespace

bool is_data_uri(std::string_view uri)
{
    constexpr std::string_view kData = "data:";
    return uri.size() >= kData.size() &&
           std::equal(kData.begin(), kData.end(), uri.begin(), [](char a, char b) {
               return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
           });
}

std::optional<std::string> decode_data_uri(std::string_view uri, std::string& mime_type)
{
    const std::size_t comma = uri.find(',');
    if (!is_data_uri(uri) || comma == std::string_view::npos) return std::nullopt;
    const std::string_view header = uri.substr(5, comma - 5);
    mime_type = header.substr(0, header.find(';'));
    const std::string_view data = uri.substr(comma + 1);
    if (!header.ends_with(";base64")) return percent_decoded(data);
    // Padding may be percent-encoded.
    if (data.find('%') != std::string_view::npos) return decode_base64(percent_decoded(data));
    return decode_base64(data);
}

std::string percent_decoded(std::string_view uri)
{
    std::string bytes;
    bytes.reserve(uri.size());
    for (std::size_t at = 0; at < uri.size(); ++at) {
        if (uri[at] == '%' && at + 2 < uri.size()) {
            const int high = hex_digit(uri[at + 1]), low = hex_digit(uri[at + 2]);
            if (high >= 0 && low >= 0) {
                bytes += static_cast<char>(high * 16 + low);
                at += 2;
                continue;
            }
        }
        bytes += uri[at];
    }
    return bytes;
}

bool has_scheme(std::string_view uri)
{
    const std::size_t colon = uri.find(':');
    if (colon == std::string_view::npos || colon < 2) return false;
    return std::all_of(uri.begin(), uri.begin() + std::ptrdiff_t(colon),
        [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '-' || c == '.'; });
}

std::filesystem::path resolve_uri(const std::filesystem::path& folder, const std::string& uri)
{
    std::error_code error;
    // A zero byte would end the name early.
    std::string name = percent_decoded(uri);
    name.erase(std::remove(name.begin(), name.end(), '\0'), name.end());
    const std::filesystem::path decoded = folder / name;
    if (std::filesystem::exists(decoded, error)) return decoded;
    const std::filesystem::path raw = folder / uri.c_str();
    if (std::filesystem::exists(raw, error)) return raw;
    std::replace(name.begin(), name.end(), '\\', '/');
    const std::filesystem::path slashes = folder / name;
    return std::filesystem::exists(slashes, error) ? slashes : decoded;
}

} // namespace firsthit::gltf
