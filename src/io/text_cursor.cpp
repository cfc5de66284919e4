// text_cursor.cpp - walks a text line by line and word by word.
#include "io/text_cursor.h"

#include "io/parse_number.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace firsthit {
namespace {

bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

} // namespace

std::string printable(std::string_view word)
{
    std::string shown(word.substr(0, 40));
    for (char& c : shown)
        if (c < ' ' || c > '~') c = '?';
    return word.size() > 40 ? shown + "..." : shown;
}

TextCursor::TextCursor(std::string_view text, std::string name, bool backslash)
    : text_(text),
      name_(std::move(name)),
      backslash_(backslash)
{
}

bool TextCursor::next_line()
{
    if (next_ >= text_.size()) return false;
    ++line_;
    at_ = next_;
    end_ = at_;
    while (end_ < text_.size() && text_[end_] != '\n' && text_[end_] != '\r') ++end_;
    const bool cr_lf = text_.substr(end_, 2) == "\r\n";
    next_ = std::min(text_.size(), end_ + (cr_lf ? 2 : 1));
    return true;
}

std::string_view TextCursor::next_word()
{
    do {
        while (at_ < end_ && is_blank(text_[at_])) ++at_;
        const std::size_t first = at_;
        while (at_ < end_ && !is_blank(text_[at_])) ++at_;
        word_ = text_.substr(first, at_ - first);
        if (!backslash_ || at_ < end_ || word_.empty() || word_.back() != '\\') break;
        word_.remove_suffix(1);
        next_line();
    } while (word_.empty());
    return word_;
}

bool TextCursor::has_word()
{
    while (at_ < end_ && is_blank(text_[at_])) ++at_;
    return at_ < end_;
}

std::string_view TextCursor::rest_of_line()
{
    std::size_t last = end_;
    while (at_ < last && is_blank(text_[at_])) ++at_;
    while (last > at_ && is_blank(text_[last - 1])) --last;
    const std::string_view rest = text_.substr(at_, last - at_);
    at_ = end_;
    return rest;
}

float TextCursor::number(std::string_view what)
{
    if (next_word().empty()) fail(fmt::format("the line ends before {}", what));
    const std::optional<float> value = parse_float(word_);
    if (!value) fail(fmt::format("{} is '{}', a number is needed", what, printable(word_)));
    if (!std::isfinite(*value))
        throw SceneError(fmt::format(
            "{}:{}: {} is {}, not a finite float", name_, line_, what, printable(word_)));
    return *value;
}

std::int64_t TextCursor::integer(std::string_view what)
{
    if (next_word().empty()) fail(fmt::format("the line ends before {}", what));
    const std::optional<std::int64_t> value = parse_integer(word_);
    if (!value) fail(fmt::format("{} is '{}', a whole number is needed", what, printable(word_)));
    return *value;
}

void TextCursor::expect_end()
{
    if (!next_word().empty())
        fail(fmt::format("'{}' is more than belongs on this line", printable(word_)));
}

void TextCursor::fail(std::string_view message) const
{
    throw FileError(fmt::format("{}:{}: {}", name_, line_, message));
}

} // namespace firsthit
