// token_reader.h - walks a text word by word, whatever its lines are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace firsthit {

/// Words are separated by white space of any kind. It reads what it is given and owns nothing.
class TokenReader {
  public:
    /// text  a byte follows it that is white space or zero, as behind a std::string
    /// name  of the file, for messages
    TokenReader(std::string_view text, const std::string& name);

    /// Counts lines from here on as if that many had gone before.
    void start_after(std::size_t lines) { lines_before_ = lines; }
    /// Goes to a place in the text.
    void seek(std::size_t at) { at_ = text_.data() + at; }
    /// All of the text.
    std::string_view text() const { return text_; }
    /// Bytes up to the end of the last word.
    std::size_t consumed() const { return static_cast<std::size_t>(at_ - text_.data()); }

    /// Is there another word?
    bool has_word();
    /// The next word, empty at the end of the text.
    std::string_view next_word();
    /// What is left of the line, without the blanks at both ends.
    std::string_view rest_of_line();

    /// The next word as a number, rounded once; it may be infinite or NaN.
    /// throws  FileError where there is none or it is no number. `what` names it
    float number(std::string_view what);
    /// throws  FileError where there is none or it is no whole number of 64 bits; "3.0" is one
    std::int64_t integer(std::string_view what);

    /// Throws FileError "name:line: message", with the line of the last word.
    [[noreturn]] void fail(std::string_view message) const;
    /// The line that the last word ends in, from 1. Takes a pass over the text before it.
    std::size_t line() const;

  private:
    void skip_blanks();
    [[noreturn]] void fail_number(const char* from, std::string_view what, std::string_view needed);

    std::string_view text_;
    const std::string* name_;
    const char* at_;
    const char* end_;
    std::size_t lines_before_ = 0;
};

} // namespace firsthit
