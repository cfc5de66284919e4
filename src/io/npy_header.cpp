// npy_header.cpp - the text before a NumPy array.
//
// source  NumPy Enhancement Proposal 1, "A Simple File Format for NumPy Arrays"
#include "io/npy_header.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <charconv>
#include <optional>

namespace firsthit {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";

/// NumPy's own limit on a header that it reads without being asked to.
constexpr std::size_t kLongestHeader = 10000;

/// Python's text of a dictionary with strings, truths and tuples of whole numbers: what NumPy
/// writes, and nothing else of Python.
class HeaderText {
  public:
    HeaderText(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    NpyHeader read()
    {
        NpyHeader header;
        bool descr = false, order = false, shape = false;
        expect('{');
        while (!take('}')) {
            const std::string key = string();
            expect(':');
            if (key == "descr" && !descr) {
                header.descr = string();
                descr = true;
            } else if (key == "fortran_order" && !order) {
                header.fortran_order = truth();
                order = true;
            } else if (key == "shape" && !shape) {
                header.shape = tuple();
                shape = true;
            } else {
                fail(fmt::format("unexpected key '{}'", key));
            }
            if (!take(',')) {
                expect('}');
                break;
            }
        }
        skip_blanks();
        if (!text_.empty()) fail("more text after the dictionary");
        if (!descr || !order || !shape) fail("descr, fortran_order or shape is missing");
        return header;
    }

  private:
    [[noreturn]] void fail(const std::string& what) const
    {
        throw FileError(fmt::format("{}: the NumPy header is malformed: {}", name_, what));
    }

    void skip_blanks()
    {
        const std::size_t first = text_.find_first_not_of(" \t\n");
        text_.remove_prefix(first == std::string_view::npos ? text_.size() : first);
    }

    bool take(char c)
    {
        skip_blanks();
        if (text_.empty() || text_[0] != c) return false;
        text_.remove_prefix(1);
        return true;
    }

    void expect(char c)
    {
        if (!take(c)) fail(fmt::format("'{}' is missing", c));
    }

    std::string string()
    {
        skip_blanks();
        const char quote = text_.empty() ? '\0' : text_[0];
        if (quote != '\'' && quote != '"')
            fail("a string is missing; arrays of records are not read");
        const std::size_t end = text_.find(quote, 1);
        if (end == std::string_view::npos) fail("a string does not end");
        std::string result;
        for (const char c : text_.substr(1, end - 1)) {
            if (c < ' ' || c > '~' || c == '\\') fail("a string has other than plain characters");
            result += c;
        }
        text_.remove_prefix(end + 1);
        return result;
    }

    bool truth()
    {
        skip_blanks();
        for (const std::string_view word : {"True", "False"}) {
            if (text_.substr(0, word.size()) != word) continue;
            text_.remove_prefix(word.size());
            return word == "True";
        }
        fail("fortran_order is neither True nor False");
    }

    std::vector<std::uint64_t> tuple()
    {
        std::vector<std::uint64_t> result;
        expect('(');
        while (!take(')')) {
            skip_blanks();
            std::uint64_t size = 0;
            const auto [end, error] =
                std::from_chars(text_.data(), text_.data() + text_.size(), size);
            if (error != std::errc()) fail("the shape is no tuple of whole numbers");
            text_.remove_prefix(std::size_t(end - text_.data()));
            if (text_.substr(0, 1) == "L") text_.remove_prefix(1); // Python 2
            result.push_back(size);
            if (result.size() > 32) fail("more than 32 dimensions");
            if (!take(',')) {
                expect(')');
                break;
            }
        }
        return result;
    }

    std::string_view text_;
    const std::string& name_;
};

} // namespace

NpyHeader parse_npy_header(std::string_view bytes, const std::string& name)
{
    if (bytes.substr(0, kMagic.size()) != kMagic)
        throw FileError(fmt::format("{}: this is no NumPy file (.npy): it does not begin with "
                                    "\\x93NUMPY",
            name));
    const auto byte = [&](std::size_t k) { return std::size_t(std::uint8_t(bytes[k])); };
    const auto cut_off = [&] {
        return FileError(fmt::format("{}: the file ends within its header", name));
    };
    if (bytes.size() < 10) throw cut_off();
    const std::size_t version = byte(6);
    if (version < 1 || version > 3 || byte(7) != 0)
        throw FileError(fmt::format("{}: NumPy format {}.{} is not known: accepted are 1.0, 2.0 "
                                    "and 3.0",
            name, version, byte(7)));
    std::size_t start = 10, length = byte(8) + (byte(9) << 8);
    if (version > 1) {
        if (bytes.size() < 12) throw cut_off();
        start = 12;
        length += (byte(10) << 16) + (byte(11) << 24);
    }
    if (length > kLongestHeader)
        throw FileError(fmt::format("{}: the NumPy header has {} bytes: at most {} are accepted",
            name, length, kLongestHeader));
    if (bytes.size() - start < length) throw cut_off();
    NpyHeader header = HeaderText(bytes.substr(start, length), name).read();
    header.data_at = start + length;
    return header;
}

std::string npy_header(const std::string& descr, const std::string& shape)
{
    std::string text =
        fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", descr, shape);
    // Magic, version and length are 10 bytes; the data starts at a multiple of 64, after a newline.
    const std::size_t length = (10 + text.size() + 1 + 63) / 64 * 64 - 10;
    text.resize(length - 1, ' ');
    text += '\n';
    std::string header(kMagic);
    header += {1, 0, static_cast<char>(length & 0xFF), static_cast<char>(length >> 8)};
    return header + text;
}

} // namespace firsthit
