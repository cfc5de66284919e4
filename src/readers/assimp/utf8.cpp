// utf8.cpp - text of two bytes a letter as UTF-8.
#include "readers/assimp/utf8.h"

#include <cstddef>
#include <cstdint>

namespace firsthit {
namespace {

void append(std::string& text, std::uint32_t letter)
{
    const auto add = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
    const auto add_rest = [&](int parts) {
        for (int k = parts - 1; k >= 0; --k) add(0x80 | (letter >> (6 * k) & 0x3F));
    };
    if (letter < 0x80) {
        add(letter);
    } else if (letter < 0x800) {
        add(0xC0 | letter >> 6);
        add_rest(1);
    } else if (letter < 0x10000) {
        add(0xE0 | letter >> 12);
        add_rest(2);
    } else {
        add(0xF0 | letter >> 18);
        add_rest(3);
    }
}

} // namespace

std::string as_utf8(const std::string& text)
{
    const bool little = text.starts_with("\xFF\xFE");
    if (!little && !text.starts_with("\xFE\xFF")) return text;
    const auto unit = [&](std::size_t k) {
        const auto low = static_cast<unsigned char>(text[k + (little ? 0 : 1)]);
        const auto high = static_cast<unsigned char>(text[k + (little ? 1 : 0)]);
        return std::uint32_t(low) | std::uint32_t(high) << 8;
    };
    constexpr std::uint32_t kUnknown = 0xFFFD;
    std::string made;
    made.reserve(text.size() / 2);
    for (std::size_t k = 2; k + 1 < text.size(); k += 2) {
        std::uint32_t letter = unit(k);
        if (0xD800 <= letter && letter < 0xE000) {
            // The first half of a letter, if the second follows.
            const std::uint32_t next = k + 3 < text.size() ? unit(k + 2) : 0;
            const bool pair = letter < 0xDC00 && 0xDC00 <= next && next < 0xE000;
            letter = pair ? 0x10000 + ((letter - 0xD800) << 10) + (next - 0xDC00) : kUnknown;
            if (pair) k += 2;
        }
        append(made, letter);
    }
    return made;
}

} // namespace firsthit
