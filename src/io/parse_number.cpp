// parse_number.cpp - numbers from words, the same in every locale.
#include "io/parse_number.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>
#include <string>
#include <system_error>

namespace firsthit {
namespace {

/// from_chars knows no leading plus.
std::string_view without_plus(std::string_view word)
{
    const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+';
    return plus ? word.substr(1) : word;
}

template <class Number>
std::errc read(std::string_view word, Number& value)
{
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    return stop == end ? error : std::errc::invalid_argument;
}

/// Whether a number that no float or double holds is too small for it, not too large: from the place
/// of its first digit that counts, before or after the point, and its exponent.
bool is_tiny(std::string_view number)
{
    const std::size_t e = std::min(number.find_first_of("eE"), number.size());
    const std::string_view digits = number.substr(0, e);
    const std::size_t point = std::min(digits.find('.'), digits.size());
    const auto place =
        static_cast<double>(point) - static_cast<double>(digits.find_first_of("123456789"));
    if (e == number.size()) return place < 0;
    const std::string_view exponent = without_plus(number.substr(e + 1));
    std::int64_t value = 0;
    if (read(exponent, value) != std::errc()) return exponent[0] == '-'; // beyond 64 bits
    return place + static_cast<double>(value) < 0;
}

template <class Real>
std::optional<Real> parse_real(std::string_view word)
{
    word = without_plus(word);
    Real value = 0;
    const std::errc error = read(word, value);
    if (error == std::errc::invalid_argument) return {};
    if (error != std::errc::result_out_of_range) return value;
    if (!is_tiny(word)) return std::numeric_limits<Real>::infinity();
    return word[0] == '-' ? -Real(0) : Real(0);
}

} // namespace

bool says_no_number(std::string_view word)
{
    if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.remove_prefix(1);
    std::string first(word.substr(0, 3));
    std::transform(first.begin(), first.end(), first.begin(),
        [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return first == "nan" || first == "inf" || first == "1.#";
}

std::optional<double> parse_number(std::string_view word)
{
    return parse_real<double>(word);
}
std::optional<float> parse_float(std::string_view word)
{
    return parse_real<float>(word);
}

std::optional<std::int64_t> parse_integer(std::string_view word)
{
    std::int64_t value = 0;
    if (read(without_plus(word), value) != std::errc()) return {};
    return value;
}

} // namespace firsthit
