// obj_lines.h - the statements of an OBJ file, each a line or several that a backslash joins.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace firsthit {

/// Goes through a text statement by statement. Lines end with LF, CR LF or CR. A line that ends in a
/// backslash goes on in the next one, except in a comment, which ends with its line.
class ObjLines {
  public:
    /// text  without a byte order mark; kept by reference
    explicit ObjLines(std::string_view text);

    /// Goes to the next statement.
    /// returns  false at the end of the text
    bool next();

    /// The statement, without its line ends; may be empty. Valid until next() is called.
    std::string_view statement() const { return statement_; }
    /// The number of its first line, from 1.
    std::size_t line() const { return line_; }

  private:
    std::string_view next_line();
    void join_lines();

    std::string_view text_;
    bool has_cr_; // somewhere in the text
    std::size_t at_ = 0;
    std::size_t line_ = 0;
    std::size_t lines_ = 0; // read so far
    std::string_view statement_;
    std::string joined_;
};

/// The text of an OBJ or MTL file without a byte order mark.
/// throws  FileError: UTF-16
std::string_view obj_text(std::string_view bytes, const std::string& name);

/// Whether it separates words.
inline bool is_obj_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/// Takes the first word off a text, with the blanks before it; empty where there is none.
inline std::string_view take_obj_word(std::string_view& text)
{
    std::size_t first = 0;
    while (first < text.size() && is_obj_blank(text[first])) ++first;
    std::size_t last = first;
    while (last < text.size() && !is_obj_blank(text[last])) ++last;
    const std::string_view word = text.substr(first, last - first);
    text.remove_prefix(last);
    return word;
}

/// Without the blanks at both ends.
std::string_view without_blanks(std::string_view text);

} // namespace firsthit
