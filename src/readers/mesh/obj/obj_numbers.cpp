// obj_numbers.cpp - the numbers of a statement, in all forms that exporters write.
#include "readers/mesh/obj/obj_numbers.h"

#include "io/parse_number.h"
#include "readers/mesh/obj/obj_lines.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string>
#include <system_error>

namespace firsthit {
namespace {

/// The text up to a comment.
std::string_view without_comment(std::string_view text)
{
    return text.substr(0, std::min(text.find('#'), text.size()));
}

std::string with_commas_as(std::string_view text, char other)
{
    std::string changed(text);
    std::replace(changed.begin(), changed.end(), ',', other);
    return changed;
}

/// Whether all commas are within numbers, of which there are as many as usual, and not behind them.
bool are_decimal(std::string_view text, std::size_t usual)
{
    std::size_t words = 0;
    for (std::string_view word = take_obj_word(text); !word.empty(); word = take_obj_word(text)) {
        ++words;
        const std::size_t comma = word.find(',');
        if (comma == word.npos) continue;
        if (comma + 1 == word.size() || !parse_float(with_commas_as(word, '.'))) return false;
    }
    return words >= usual;
}

ObjNumbers read_with_commas(std::string_view text, std::size_t usual)
{
    const std::string_view numbers = without_comment(text);
    ObjNumbers read =
        read_obj_numbers(with_commas_as(numbers, are_decimal(numbers, usual) ? '.' : ' '), usual);
    read.has_comma = true;
    return read;
}

} // namespace

ObjNumbers read_obj_numbers(std::string_view text, std::size_t usual)
{
    ObjNumbers read;
    const char* at = text.data();
    const char* const end = at + text.size();
    for (;;) {
        while (at < end && is_obj_blank(*at)) ++at;
        if (at == end || *at == '#') break;
        if (read.count == ObjNumbers::kMost) {
            if (without_comment({at, end}).find(',') != std::string_view::npos)
                return read_with_commas(text, usual);
            break;
        }
        // Nearly all words are numbers that need no more than this.
        float value = 0;
        const auto [stop, error] = std::from_chars(at, end, value);
        if (error == std::errc() && (stop == end || is_obj_blank(*stop))) {
            read.value[read.count++] = value;
            at = stop;
            continue;
        }
        const char* last = at;
        // "1.#QNAN" is no comment, but how some programs write NaN.
        while (last < end && !is_obj_blank(*last) && (*last != '#' || last[-1] == '.')) ++last;
        const std::string_view word(at, last);
        if (word.find(',') != word.npos) return read_with_commas(text, usual);
        read.value[read.count++] =
            parse_float(word).value_or(std::numeric_limits<float>::quiet_NaN());
        at = last;
    }
    return read;
}

} // namespace firsthit
