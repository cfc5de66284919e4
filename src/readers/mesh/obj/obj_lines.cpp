// obj_lines.cpp - the statements of an OBJ file, each a line or several that a backslash joins.
#include "readers/mesh/obj/obj_lines.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>

namespace firsthit {
namespace {

/// Whether a word of it begins with the character of comments.
bool has_comment(std::string_view line)
{
    for (std::size_t k = line.find('#'); k != line.npos; k = line.find('#', k + 1))
        if (k == 0 || is_obj_blank(line[k - 1])) return true;
    return false;
}

/// Whether its last word ends in a backslash, with or without blanks behind it, and is no comment.
bool goes_on(std::string_view line)
{
    std::size_t end = line.size();
    while (end > 0 && is_obj_blank(line[end - 1])) --end;
    return end > 0 && line[end - 1] == '\\' && !has_comment(line);
}

} // namespace

ObjLines::ObjLines(std::string_view text) : text_(text), has_cr_(text.find('\r') != text.npos) {}

bool ObjLines::next()
{
    if (at_ >= text_.size()) return false;
    statement_ = next_line();
    line_ = lines_;
    if (goes_on(statement_)) join_lines();
    return true;
}

std::string_view ObjLines::next_line()
{
    ++lines_;
    const std::string_view rest = text_.substr(at_);
    std::size_t end = std::min(rest.find('\n'), rest.size());
    // Only a text with a CR is looked through for it, up to the LF: a second look at each byte.
    if (has_cr_) end = std::min(rest.substr(0, end).find('\r'), end);
    const std::size_t taken = rest.substr(end, 2) == "\r\n" ? 2 : 1;
    at_ = std::min(text_.size(), at_ + end + taken);
    return rest.substr(0, end);
}

void ObjLines::join_lines()
{
    joined_.clear();
    std::string_view line = statement_;
    for (;;) {
        const bool more = goes_on(line);
        joined_ += more ? line.substr(0, line.rfind('\\')) : line;
        joined_ += ' ';
        if (!more || at_ >= text_.size()) break;
        line = next_line();
    }
    statement_ = joined_;
}

std::string_view obj_text(std::string_view bytes, const std::string& name)
{
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
        throw FileError(fmt::format(
            "{}: the text is UTF-16; UTF-8, ASCII and other encodings of one byte are accepted",
            name));
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    return bytes;
}

std::string_view without_blanks(std::string_view text)
{
    while (!text.empty() && is_obj_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_obj_blank(text.back())) text.remove_suffix(1);
    return text;
}

} // namespace firsthit
