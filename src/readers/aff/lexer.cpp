// lexer.cpp - cuts the text of one AFF file into tokens.
#include "readers/aff/lexer.h"

#include "io/parse_number.h"

#include <firsthit/error.h>

#include <cmath>
#include <limits>
#include <utility>

namespace firsthit::aff {
namespace {

bool is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
}

bool is_comment(char c)
{
    return c == '#' || c == '%';
}
bool is_brace(char c)
{
    return c == '{' || c == '}';
}

} // namespace

std::string in_quotes(std::string_view token)
{
    constexpr std::size_t kShown = 40;
    constexpr char kHex[] = "0123456789abcdef";
    std::string text = "'";
    for (const char c : token.substr(0, kShown)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && byte < 0x7f)
            text += c;
        else
            text += {'\\', 'x', kHex[byte >> 4], kHex[byte & 15]};
    }
    return text + (token.size() > kShown ? "...'" : "'");
}

Lexer::Lexer(std::string file, std::string_view text) : file_(std::move(file)), text_(text)
{
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3); // a byte order mark
}

Lexer::Token Lexer::find_token() const
{
    std::size_t at = cursor_;
    std::size_t line = line_;
    while (at < text_.size() && (is_space(text_[at]) || is_comment(text_[at]))) {
        if (is_comment(text_[at]))
            while (at < text_.size() && text_[at] != '\n' && text_[at] != '\r') ++at;
        else {
            const bool cr_lf = text_[at] == '\n' && at > 0 && text_[at - 1] == '\r';
            if ((text_[at] == '\n' && !cr_lf) || text_[at] == '\r') ++line;
            ++at;
        }
    }
    std::size_t end = at;
    if (end < text_.size() && is_brace(text_[end]))
        ++end;
    else
        while (end < text_.size() && !is_space(text_[end]) && !is_comment(text_[end]) &&
               !is_brace(text_[end]))
            ++end;
    return {text_.substr(at, end - at), line, end};
}

std::string_view Lexer::peek()
{
    if (!ahead_) ahead_ = find_token();
    return ahead_->text;
}

bool Lexer::has_more_on_line()
{
    return !peek().empty() && !is_brace(peek()[0]) && ahead_->line == line_;
}

std::string_view Lexer::next()
{
    const Token token = ahead_ ? *ahead_ : find_token();
    ahead_.reset();
    cursor_ = token.end;
    line_ = token.line;
    return token.text;
}

std::string_view Lexer::word(const char* what)
{
    const std::string_view token = next();
    if (token.empty()) fail_file(std::string("the file ends where ") + what + " should stand");
    if (is_brace(token[0]))
        fail_file("found " + in_quotes(token) + " where " + what + " should stand");
    return token;
}

void Lexer::expect(std::string_view token, const char* statement)
{
    const std::string_view found = next();
    if (found == token) return;
    const std::string wanted = in_quotes(token) + " of statement '" + statement + "' should stand";
    if (found.empty()) fail_file("the file ends where " + wanted);
    fail_file("found " + in_quotes(found) + " where " + wanted);
}

double Lexer::number(const char* what)
{
    const std::string_view token = word(what);
    const std::optional<double> value = parse_number(token);
    if (!value) fail_file(std::string(what) + " should be a number, not " + in_quotes(token));
    if (!std::isfinite(*value))
        fail_scene(std::string(what) + " should be a finite number, not " + in_quotes(token));
    return *value;
}

float Lexer::small_number(const char* what)
{
    const std::string_view token = word(what);
    const std::optional<float> value = parse_float(token);
    if (!value) fail_file(std::string(what) + " should be a number, not " + in_quotes(token));
    if (std::isfinite(*value)) return *value;
    if (std::isfinite(parse_number(token).value()))
        fail_scene(std::string(what) + " is too large: it must lie within +-3.4e38");
    fail_scene(std::string(what) + " should be a finite number, not " + in_quotes(token));
}

std::int64_t Lexer::integer(const char* what)
{
    const std::string_view token = word(what);
    const std::optional<std::int64_t> value = parse_integer(token);
    if (!value) fail_file(std::string(what) + " should be a whole number, not " + in_quotes(token));
    return *value;
}

std::uint32_t Lexer::count(const char* what)
{
    const std::int64_t value = integer(what);
    if (value < 0 || value > std::int64_t(std::numeric_limits<std::uint32_t>::max()))
        fail_file(std::string(what) + " should lie between 0 and 4294967295, not be " +
                  std::to_string(value));
    return static_cast<std::uint32_t>(value);
}

glm::dvec3 Lexer::triple(const char* what)
{
    const double x = number(what);
    const double y = number(what);
    return {x, y, number(what)};
}

glm::vec3 Lexer::small_triple(const char* what)
{
    const float x = small_number(what);
    const float y = small_number(what);
    return {x, y, small_number(what)};
}

glm::vec2 Lexer::small_pair(const char* what)
{
    const float x = small_number(what);
    return {x, small_number(what)};
}

glm::vec3 Lexer::any_triple(const char* what)
{
    glm::vec3 read(0);
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view token = word(what);
        const std::optional<float> value = parse_float(token);
        if (!value && !says_no_number(token))
            fail_file(std::string(what) + " should be a number, not " + in_quotes(token));
        read[axis] = value.value_or(std::numeric_limits<float>::quiet_NaN());
    }
    return read;
}

std::optional<float> Lexer::small_number_if_next(const char* what)
{
    if (!parse_number(peek())) return {};
    return small_number(what);
}

glm::dvec3 Lexer::radii(const char* what)
{
    glm::dvec3 radius(small_number(what));
    for (int axis = 1; axis < 3 && has_more_on_line(); ++axis)
        radius[axis] = small_number_if_next(what).value_or(static_cast<float>(radius[axis]));
    return radius;
}

std::string Lexer::place() const
{
    return file_ + ":" + std::to_string(line_) + ": ";
}

void Lexer::fail_file(const std::string& message) const
{
    throw FileError(place() + message);
}

void Lexer::fail_scene(const std::string& message) const
{
    throw SceneError(place() + message);
}

} // namespace firsthit::aff
