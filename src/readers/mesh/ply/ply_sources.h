// ply_sources.h - where the values of a PLY file come from: bytes, words, or words of one line.
//
// The three have the same functions:
//
//     float number(PlyType type)              the next value, rounded to float
//     std::int64_t whole(PlyType type)        the next value, a whole number
//     void skip(PlyType type, n)              leaves out n values
//     void end_element()                      called behind each element
//     std::string place()                     where it is, for messages: "m.ply:7", "m.ply"
#pragma once

#include "readers/mesh/ply/ply_header.h"
#include "io/scan_number.h"
#include "io/token_reader.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace firsthit {

/// Thrown where the file ends within an element.
struct PlyFileEnds {};

/// Thrown by PlyLine where a line is not one element of plain numbers.
struct PlyOtherLines {};

class PlyBytes {
  public:
    PlyBytes(std::string_view body, bool big_endian, const std::string& name)
        : body_(body),
          big_endian_(big_endian),
          name_(name)
    {
    }

    void seek(std::size_t at) { at_ = at; }
    std::size_t consumed() const { return at_; }
    bool has_more() const { return at_ < body_.size(); }

    float number(PlyType type)
    {
        switch (type) {
        case PlyType::int8:
            return float(take<std::int8_t>());
        case PlyType::uint8:
            return float(take<std::uint8_t>());
        case PlyType::int16:
            return float(take<std::int16_t>());
        case PlyType::uint16:
            return float(take<std::uint16_t>());
        case PlyType::int32:
            return float(take<std::int32_t>());
        case PlyType::uint32:
            return float(take<std::uint32_t>());
        case PlyType::float32:
            return take<float>();
        case PlyType::float64:
            return float(take<double>());
        case PlyType::int64:
            return float(take<std::int64_t>());
        case PlyType::uint64:
            return float(take<std::uint64_t>());
        }
        return 0;
    }

    std::int64_t whole(PlyType type)
    {
        switch (type) {
        case PlyType::int8:
            return take<std::int8_t>();
        case PlyType::uint8:
            return take<std::uint8_t>();
        case PlyType::int16:
            return take<std::int16_t>();
        case PlyType::uint16:
            return take<std::uint16_t>();
        case PlyType::int32:
            return take<std::int32_t>();
        case PlyType::uint32:
            return take<std::uint32_t>();
        case PlyType::float32:
            return whole_of(take<float>());
        case PlyType::float64:
            return whole_of(take<double>());
        case PlyType::int64:
        case PlyType::uint64: // beyond 2^63: negative, and so out of range
            return take<std::int64_t>();
        }
        return 0;
    }

    void skip(PlyType type, std::size_t count)
    {
        const std::size_t size = ply_type_size(type);
        if ((body_.size() - at_) / size < count) throw PlyFileEnds();
        at_ += size * count;
    }

    void end_element() {}
    std::string place() const { return name_; }

  private:
    template <class T>
    T take()
    {
        if (body_.size() - at_ < sizeof(T)) throw PlyFileEnds();
        std::array<char, sizeof(T)> bytes;
        std::memcpy(bytes.data(), body_.data() + at_, sizeof(T));
        if (big_endian_) std::reverse(bytes.begin(), bytes.end());
        at_ += sizeof(T);
        T value;
        std::memcpy(&value, bytes.data(), sizeof(T));
        return value;
    }

    std::int64_t whole_of(double value) const
    {
        // Written so that NaN fails too.
        if (!(value == std::floor(value) && std::abs(value) < 9e15))
            throw FileError(
                fmt::format("{}: {} stands where a whole number is needed", name_, value));
        return static_cast<std::int64_t>(value);
    }

    std::string_view body_;
    bool big_endian_;
    const std::string& name_;
    std::size_t at_ = 0;
};

class PlyWords {
  public:
    PlyWords(std::string_view body, std::size_t lines_before, const std::string& name)
        : text_(body, name),
          name_(name)
    {
        text_.start_after(lines_before);
    }

    void seek(std::size_t at) { text_.seek(at); }
    std::size_t consumed() const { return text_.consumed(); }
    bool has_more() { return text_.has_word(); }

    float number(PlyType)
    {
        if (!text_.has_word()) throw PlyFileEnds();
        TokenReader ahead = text_;
        if (!says_no_number(ahead.next_word())) return text_.number("a value");
        text_ = ahead;
        return NAN;
    }

    std::int64_t whole(PlyType)
    {
        if (!text_.has_word()) throw PlyFileEnds();
        return text_.integer("an index or length");
    }

    void skip(PlyType, std::size_t count)
    {
        for (std::size_t k = 0; k < count; ++k)
            if (text_.next_word().empty()) throw PlyFileEnds();
    }

    void end_element() {}
    std::string place() const { return fmt::format("{}:{}", name_, text_.line()); }

  private:
    TokenReader text_;
    const std::string& name_;
};

/// Every line is one element: a way to read a text in parts. Gives up where it is not, or has a form
/// that is seldom.
class PlyLine {
  public:
    /// at   begin of a line
    /// end  of the text
    PlyLine(const char* at, const char* end) : at_(at), end_(end) {}

    const char* at() const { return at_; }

    float number(PlyType)
    {
        skip_blanks();
        float value = 0;
        at_ = is_line_end() ? nullptr : scan_float(at_, end_, value);
        if (!at_) throw PlyOtherLines();
        return value;
    }

    std::int64_t whole(PlyType)
    {
        skip_blanks();
        std::uint32_t value = 0;
        at_ = at_ == end_ ? nullptr : scan_index(at_, value);
        if (!at_) throw PlyOtherLines();
        return value;
    }

    void skip(PlyType, std::size_t count)
    {
        for (std::size_t k = 0; k < count; ++k) {
            skip_blanks();
            if (is_line_end()) throw PlyOtherLines();
            while (at_ != end_ && !is_word_end(*at_)) ++at_;
        }
    }

    void end_element()
    {
        skip_blanks();
        if (!is_line_end()) throw PlyOtherLines();
        if (at_ != end_) ++at_;
    }

    std::string place() const { throw PlyOtherLines(); }

  private:
    bool is_line_end() const { return at_ == end_ || *at_ == '\n'; }
    void skip_blanks()
    {
        while (at_ != end_ && *at_ != '\n' && is_word_end(*at_)) ++at_;
    }

    const char* at_;
    const char* end_;
};

} // namespace firsthit
