// scan_number.h - numbers at the begin of a long text, quickly: for files with millions of them.
//
// The text must end with a byte that is none of a number's, as the zero behind a std::string is.
//
// source  Clinger 1990, "How to Read Floating Point Numbers Accurately": the case of few digits
#pragma once

#include "io/parse_number.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace firsthit {

/// Where a word ends: at white space, or at the text's end.
inline bool is_word_end(char c)
{
    return static_cast<unsigned char>(c) <= ' ';
}

namespace scanning {

/// Powers of ten that a double holds exactly.
inline constexpr std::array<double, 23> kPowers = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9,
    1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

inline bool is_digit(char c)
{
    return static_cast<unsigned char>(c - '0') < 10;
}

/// Reads a run of digits into a number, of which those beyond 19 in all do not fit.
inline const char* scan_digits(const char* at, std::uint64_t& number)
{
    for (; is_digit(*at); ++at) number = number * 10 + static_cast<std::uint64_t>(*at - '0');
    return at;
}

/// The word at a place as parse_float reads it. Returns its end, or null where it is no number.
const char* scan_any_float(const char* at, const char* end, float& value);

} // namespace scanning

/// Reads a number that a word's end follows, rounded once to float: parse_float gives the same bits.
/// Infinite and NaN where the word says so, or no float holds it.
///
/// at       the word's first character
/// end      of the text
/// returns  the word's end; null where the word is no number
inline const char* scan_float(const char* at, const char* end, float& value)
{
    using namespace scanning;
    const char* const first = at;
    const bool minus = *at == '-';
    if (minus) ++at;
    std::uint64_t number = 0;
    const char* const digits = at;
    at = scan_digits(at, number);
    std::ptrdiff_t count = at - digits;
    std::ptrdiff_t exponent = 0;
    if (*at == '.') {
        const char* const fraction = ++at;
        at = scan_digits(at, number);
        exponent = fraction - at;
        count -= exponent;
    }
    if (count > 0 && (*at == 'e' || *at == 'E')) {
        ++at;
        const bool down = *at == '-';
        if (down || *at == '+') ++at;
        const char* const power = at;
        std::uint64_t shift = 0;
        at = scan_digits(at, shift);
        if (at == power || at - power > 4) return scan_any_float(first, end, value);
        exponent += down ? -std::ptrdiff_t(shift) : std::ptrdiff_t(shift);
    }
    // A whole number and a power of ten that a double holds give the nearest double by one
    // operation. From there to the nearest float is right unless it lies in the middle of two, or
    // below the floats that have all their digits.
    if (is_word_end(*at) && count > 0 && count <= 19 && number < (std::uint64_t(1) << 53) &&
        -22 <= exponent && exponent <= 22) {
        const auto whole = static_cast<double>(number);
        const double rounded = exponent < 0 ? whole / kPowers[std::size_t(-exponent)]
                                            : whole * kPowers[std::size_t(exponent)];
        const std::uint64_t rest = std::bit_cast<std::uint64_t>(rounded) & 0x1FFFFFFF;
        if (rest != 0x10000000 && (rounded >= 1e-37 || number == 0) && rounded <= 1e38) {
            value = static_cast<float>(minus ? -rounded : rounded);
            return at;
        }
    }
    return scan_any_float(first, end, value);
}

/// Reads a whole number of 0 to 999999999 without sign that a word's end follows.
/// returns  the word's end; null where the word is something else, which may be another number
inline const char* scan_index(const char* at, std::uint32_t& value)
{
    std::uint64_t number = 0;
    const char* const first = at;
    while (scanning::is_digit(*at) && at - first < 10)
        number = number * 10 + static_cast<std::uint64_t>(*at++ - '0');
    if (at == first || at - first > 9 || !is_word_end(*at)) return nullptr;
    value = static_cast<std::uint32_t>(number);
    return at;
}

} // namespace firsthit
