// obj_numbers.h - the numbers of a statement, in all forms that exporters write.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace firsthit {

/// The numbers of a statement: those of "v", "vt" or "vn".
struct ObjNumbers {
    static constexpr std::size_t kMost = 8; // more are left out

    std::array<float, kMost> value{};
    std::size_t count = 0;
    bool has_comma = false; // between numbers or in the place of decimal points
};

/// Reads numbers up to the statement's end or a comment. A word that is no number is NaN, a number
/// that is too large for a float infinite.
///
/// Commas at the ends of words separate ("1.5, 2.5"). Commas within them are decimal points where all words
/// are numbers then and there are as many as there usually are ("1,5 2,5 0"), else they separate ("1,2,3").
///
/// usual  numbers that such statements have
ObjNumbers read_obj_numbers(std::string_view text, std::size_t usual);

} // namespace firsthit
