// token_reader.cpp - walks a text word by word, whatever its lines are.
#include "io/token_reader.h"

#include "io/scan_number.h"
#include "io/text_cursor.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <cmath>

namespace firsthit {

TokenReader::TokenReader(std::string_view text, const std::string& name)
    : text_(text),
      name_(&name),
      at_(text.data()),
      end_(text.data() + text.size())
{
}

void TokenReader::skip_blanks()
{
    // A zero byte within the text is white space too.
    while (at_ != end_ && is_word_end(*at_)) ++at_;
}

bool TokenReader::has_word()
{
    skip_blanks();
    return at_ != end_;
}

std::string_view TokenReader::next_word()
{
    skip_blanks();
    const char* const first = at_;
    while (at_ != end_ && !is_word_end(*at_)) ++at_;
    return {first, static_cast<std::size_t>(at_ - first)};
}

std::string_view TokenReader::rest_of_line()
{
    const auto is_blank = [](char c) { return is_word_end(c) && c != '\n' && c != '\r'; };
    while (at_ != end_ && is_blank(*at_)) ++at_;
    const char* const first = at_;
    while (at_ != end_ && *at_ != '\n' && *at_ != '\r') ++at_;
    const char* last = at_;
    while (last != first && is_blank(last[-1])) --last;
    return {first, static_cast<std::size_t>(last - first)};
}

float TokenReader::number(std::string_view what)
{
    skip_blanks();
    float value = 0;
    const char* const stop = at_ == end_ ? nullptr : scan_float(at_, end_, value);
    if (!stop) fail_number(at_, what, "a number");
    at_ = stop;
    return value;
}

std::int64_t TokenReader::integer(std::string_view what)
{
    skip_blanks();
    std::uint32_t index = 0;
    const char* const stop = at_ == end_ ? nullptr : scan_index(at_, index);
    if (stop) {
        at_ = stop;
        return index;
    }
    const char* const first = at_;
    const std::string_view word = next_word();
    if (const std::optional<std::int64_t> whole = parse_integer(word)) return *whole;
    const std::optional<double> value = parse_number(word);
    if (!value || *value != std::floor(*value) || std::abs(*value) > 9e15)
        fail_number(first, what, "a whole number");
    return static_cast<std::int64_t>(*value);
}

void TokenReader::fail_number(const char* from, std::string_view what, std::string_view needed)
{
    at_ = from;
    const std::string_view word = next_word();
    if (word.empty()) fail(fmt::format("the file ends before {}", what));
    fail(fmt::format("{} is '{}', {} is needed", what, printable(word), needed));
}

void TokenReader::fail(std::string_view message) const
{
    throw FileError(fmt::format("{}:{}: {}", *name_, line(), message));
}

std::size_t TokenReader::line() const
{
    std::size_t lines = lines_before_ + 1;
    for (const char* c = text_.data(); c != at_; ++c)
        lines += *c == '\n' || (*c == '\r' && (c + 1 == end_ || c[1] != '\n'));
    return lines;
}

} // namespace firsthit
