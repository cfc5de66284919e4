// text_cursor.h - walks a text line by line and word by word, and says where it is when it fails.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace firsthit {

/// Lines end with LF, CR LF or CR; words are separated by blanks and tabs. It reads what it is
/// given and owns nothing but its name.
class TextCursor {
  public:
    /// name       of the file, for messages
    /// backslash  a line that ends with a backslash goes on in the next one
    TextCursor(std::string_view text, std::string name, bool backslash = false);

    /// Counts lines from here on as if that many had gone before.
    void start_after(std::size_t lines) { line_ = lines; }
    /// Goes to the next line.
    /// returns  false at the end of the text
    bool next_line();
    /// The next word of the line, empty at the line's end.
    std::string_view next_word();
    /// Is there another word on the line?
    bool has_word();
    /// What is left of the line, without the blanks at both ends.
    std::string_view rest_of_line();
    /// Bytes of the text up to the end of this line, its end included.
    std::size_t consumed() const { return next_; }

    /// throws  FileError where the line has no more word or it is no number; SceneError where the
    ///         number is not finite as a float. `what` names it: "x", "face index"
    float number(std::string_view what);
    /// throws  FileError where the line has no more word or it is no whole number of 64 bits
    std::int64_t integer(std::string_view what);
    /// throws  FileError unless the line has no more words
    void expect_end();

    /// throws  FileError "name:line: message"
    [[noreturn]] void fail(std::string_view message) const;

    const std::string& name() const { return name_; }
    std::size_t line() const { return line_; }
    /// The word that next_word returned last.
    std::string_view word() const { return word_; }

  private:
    std::string_view text_;
    std::string name_;
    bool backslash_;
    std::size_t line_ = 0;
    std::size_t at_ = 0;   // next byte of the line
    std::size_t end_ = 0;  // of the line
    std::size_t next_ = 0; // start of the next line
    std::string_view word_;
};

/// A word as a message may show it: at most 40 bytes, what cannot be printed as '?'.
std::string printable(std::string_view word);

} // namespace firsthit
