// parse_number.h - numbers from words, the same in every locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace firsthit {

/// The whole word as a number; a plus may stand in front. Nothing where it is none. Too small for a
/// double is 0 of its sign, too large is +inf, of either sign; "inf" and "nan" are numbers that are not finite.
std::optional<double> parse_number(std::string_view word);

/// The same as a float, rounded once: float(double) can be off by a unit in the last place. Too small
/// is 0 of its sign.
std::optional<float> parse_float(std::string_view word);

/// The same for whole numbers; nothing also where 64 bits do not hold it.
std::optional<std::int64_t> parse_integer(std::string_view word);

/// Whether a word is one of those that programs write for numbers that are none: "nan", "-nan(ind)", "Inf",
/// "1.#QNAN" and the like, of which only some are numbers of C++.
bool says_no_number(std::string_view word);

} // namespace firsthit
