// lexer.h - cuts the text of one AFF file into tokens, and knows the line of each.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace firsthit::aff {

/// A token as an error message shows it: in quotes, at most 40 bytes, odd bytes as \xNN.
std::string in_quotes(std::string_view token);

/// Tokens are separated by white space; `{` and `}` are tokens of their own, and `#` and `%` start
/// a comment to the end of the line wherever they stand. Errors name the file and the line.
class Lexer {
  public:
    /// text  must outlive the lexer
    Lexer(std::string file, std::string_view text);

    const std::string& file() const { return file_; }
    /// Of the token that was taken last, from 1.
    std::size_t line() const { return line_; }
    /// A place to go back to.
    struct Mark {
        std::size_t cursor, line;
    };
    Mark mark() const { return {cursor_, line_}; }
    void go_back(const Mark& mark)
    {
        cursor_ = mark.cursor;
        line_ = mark.line;
        ahead_.reset();
    }
    /// Bytes after the last token: no count can promise more tokens than half of them.
    std::size_t remaining() const { return text_.size() - cursor_; }

    /// The next token without taking it; empty at the end of the file.
    std::string_view peek();
    /// Whether the next token is on the line of the last, and no brace.
    bool has_more_on_line();
    /// Takes the next token; empty at the end of the file.
    std::string_view next();

    // What follows takes one operand or more; `what` names it in the error.
    // throws  FileError: the file ends, or the token is of another kind
    //         SceneError: a number is not finite, or too large for what it is

    std::string_view word(const char* what);
    /// A token that must be exactly this one.
    void expect(std::string_view token, const char* statement);
    double number(const char* what);
    float small_number(const char* what); // one that a float can hold
    std::int64_t integer(const char* what);
    std::uint32_t count(const char* what); // 0 to 4,294,967,295
    glm::dvec3 triple(const char* what);
    glm::vec3 small_triple(const char* what);
    glm::vec2 small_pair(const char* what);
    /// Three numbers that may be not finite: what needs them is left out.
    glm::vec3 any_triple(const char* what);

    /// The next token as a number if it is one; otherwise takes nothing.
    std::optional<float> small_number_if_next(const char* what);

    /// A radius for each axis: one number for all of them or, if the line goes on with numbers, three.
    glm::dvec3 radii(const char* what);

    /// "file:line: " of the last token.
    std::string place() const;
    [[noreturn]] void fail_file(const std::string& message) const;
    [[noreturn]] void fail_scene(const std::string& message) const;

  private:
    struct Token {
        std::string_view text;
        std::size_t line = 1;
        std::size_t end = 0; // offset of the byte after it
    };
    Token find_token() const;

    std::string file_;
    std::string_view text_;
    std::size_t cursor_ = 0; // after the last token
    std::size_t line_ = 1;
    std::optional<Token> ahead_;
};

} // namespace firsthit::aff
