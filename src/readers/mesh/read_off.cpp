// read_off.cpp - Object File Format: Geomview's text files of vertices and polygons.
#include "readers/mesh/raw_mesh.h"

#include "base/srgb.h"
#include "io/parse_number.h"
#include "io/text_cursor.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace firsthit {
namespace {

/// What the file's first word says of its vertices.
struct OffKind {
    bool uv = false, color = false, normal = false;
};

/// "OFF", with ST, C and N in front of it; nothing where the word is another.
std::optional<OffKind> kind_of(std::string_view word)
{
    const auto take = [&word](std::string_view prefix) {
        const bool has = word.substr(0, prefix.size()) == prefix;
        if (has) word.remove_prefix(prefix.size());
        return has;
    };
    OffKind kind;
    kind.uv = take("ST");
    kind.color = take("C");
    kind.normal = take("N");
    if (word != "OFF") return std::nullopt;
    return kind;
}

/// Colours are displayed values: whole numbers up to 255, or others up to 1. The alpha is a share.
glm::vec4 color_of(const std::vector<std::string_view>& words, const TextCursor& text)
{
    const bool whole = std::all_of(words.begin(), words.end(),
        [](std::string_view word) { return word.find_first_of(".eE") == std::string_view::npos; });
    glm::vec4 color(1);
    for (std::size_t k = 0; k < std::min<std::size_t>(words.size(), 4); ++k) {
        const std::optional<float> value = parse_float(words[k]);
        if (!value || !std::isfinite(*value))
            text.fail(fmt::format("'{}' is no number of a colour", printable(words[k])));
        const float code = std::clamp(whole ? *value : *value * 255, 0.0f, 255.0f);
        color[static_cast<int>(k)] =
            k < 3 ? linear_from_srgb()[static_cast<std::size_t>(std::lround(code))] : code / 255;
    }
    return color;
}

class OffReader {
  public:
    OffReader(const std::string& bytes, const std::string& name)
        : text_(bytes, name),
          bytes_(bytes.size())
    {
    }

    RawMesh run()
    {
        read_kind();
        const auto vertices = count("number of vertices");
        const auto faces = count("number of faces");
        ahead_ = word_on_line(); // the number of edges, if it is there
        if (!ahead_.empty()) (void)count("number of edges");
        for (std::size_t v = 0; v < vertices; ++v) read_vertex();
        for (std::size_t f = 0; f < faces; ++f) read_face();
        check_triangle_count(mesh_.index.size(), text_.name());
        return std::move(mesh_);
    }

  private:
    /// The next word of this line; empty at its end or where a comment begins, which is passed over.
    std::string_view word_on_line()
    {
        if (!started_) return {};
        const std::string_view word = text_.next_word();
        if (word.empty() || word[0] != '#') return word;
        (void)text_.rest_of_line();
        return {};
    }

    /// The next word, on this line or a later one.
    std::string_view word(std::string_view what)
    {
        for (;;) {
            const std::string_view word = word_on_line();
            if (!word.empty()) return word;
            started_ = true;
            if (!text_.next_line())
                text_.fail(fmt::format("the file ends where there should be: {}", what));
        }
    }

    /// The words that are left on this line.
    const std::vector<std::string_view>& words_on_line()
    {
        words_.clear();
        for (std::string_view word = word_on_line(); !word.empty(); word = word_on_line())
            words_.push_back(word);
        return words_;
    }

    void read_kind()
    {
        std::string_view first = word("OFF");
        if (first.substr(0, 3) == "\xEF\xBB\xBF") first.remove_prefix(3);
        const std::optional<OffKind> kind = kind_of(first);
        if (!kind)
            text_.fail(
                fmt::format("'{}' is no kind of OFF file that is read: accepted are OFF, with "
                            "ST, C and N in front (no 4OFF, nOFF)",
                    printable(first)));
        kind_ = *kind;
        // "OFF BINARY" would be followed by numbers that are no text.
        ahead_ = word_on_line();
        if (ahead_ == "BINARY") text_.fail("binary OFF files are not read");
    }

    std::string_view next(std::string_view what)
    {
        return ahead_.empty() ? word(what) : std::exchange(ahead_, {});
    }

    /// Every vertex and face takes at least two bytes.
    std::size_t count(std::string_view what)
    {
        const std::string_view text = next(what);
        const std::optional<std::int64_t> number = parse_integer(text);
        if (!number || *number < 0)
            text_.fail(fmt::format("{} is '{}', a whole number is needed", what, printable(text)));
        if (static_cast<std::uint64_t>(*number) > bytes_ && what != "number of edges")
            text_.fail(fmt::format(
                "{} is {}, more than a file of {} bytes can have", what, *number, bytes_));
        return static_cast<std::size_t>(*number);
    }

    float number(std::string_view what)
    {
        const std::string_view text = word(what);
        const std::optional<float> value = parse_float(text);
        if (!value)
            text_.fail(fmt::format("{} is '{}', a number is needed", what, printable(text)));
        if (!std::isfinite(*value))
            throw SceneError(fmt::format("{}:{}: {} is '{}', a finite number is needed",
                text_.name(), text_.line(), what, printable(text)));
        return *value;
    }

    void read_vertex()
    {
        const float x = number("x"), y = number("y"), z = number("z");
        mesh_.position.emplace_back(x, y, z);
        if (kind_.normal) {
            const float nx = number("normal x"), ny = number("normal y"), nz = number("normal z");
            mesh_.normal.emplace_back(nx, ny, nz);
        }
        // Colours have three or four numbers: the end of the line says how many.
        if (!kind_.color && !kind_.uv) return;
        std::vector<std::string_view> rest = words_on_line();
        if (kind_.uv) {
            const std::size_t uv = rest.size() < 2 ? 0 : rest.size() - 2;
            const std::optional<float> u =
                uv + 1 < rest.size() ? parse_float(rest[uv]) : std::nullopt;
            const std::optional<float> v =
                uv + 1 < rest.size() ? parse_float(rest[uv + 1]) : std::nullopt;
            if (!u || !v || !std::isfinite(*u + *v))
                text_.fail("two texture coordinates are expected at the end of the line");
            mesh_.uv.emplace_back(*u, *v);
            rest.resize(uv);
        }
        if (!kind_.color) return;
        if (rest.size() < 3) text_.fail("a colour of three or four numbers is expected");
        mesh_.color.push_back(color_of(rest, text_));
    }

    void read_face()
    {
        const std::string_view text = word("number of corners");
        const std::optional<std::int64_t> corners = parse_integer(text);
        if (!corners || *corners < 0 || *corners > kMaxCorners)
            text_.fail(fmt::format("number of corners is '{}', a whole number up to {} is needed",
                printable(text), kMaxCorners));
        face_.clear();
        for (std::int64_t k = 0; k < *corners; ++k) face_.push_back(vertex());
        // A colour of the face may follow, or its number in a table that the file does not have.
        const std::vector<std::string_view>& rest = words_on_line();
        if (face_.size() < 3) {
            mesh_.problems.add(kThinFaces, "line", text_.line());
            return;
        }
        for (std::size_t k = 2; k < face_.size(); ++k)
            mesh_.index.emplace_back(face_[0], face_[k - 1], face_[k]);
        if (rest.size() >= 3) {
            mesh_.triangle_color.resize(mesh_.index.size() - (face_.size() - 2), glm::vec4(1));
            mesh_.triangle_color.resize(mesh_.index.size(), color_of(rest, text_));
        } else if (!mesh_.triangle_color.empty()) {
            mesh_.triangle_color.resize(mesh_.index.size(), glm::vec4(1));
        }
    }

    std::uint32_t vertex()
    {
        const std::string_view text = word("vertex");
        const std::optional<std::int64_t> number = parse_integer(text);
        if (!number)
            text_.fail(fmt::format("vertex is '{}', a whole number is needed", printable(text)));
        if (*number < 0 || *number >= static_cast<std::int64_t>(mesh_.position.size()))
            throw SceneError(fmt::format("{}:{}: vertex {} is out of range ({} vertices)",
                text_.name(), text_.line(), *number, mesh_.position.size()));
        return static_cast<std::uint32_t>(*number);
    }

    RawMesh mesh_;
    TextCursor text_;
    std::size_t bytes_;
    bool started_ = false; // on a line
    OffKind kind_;
    std::string_view ahead_; // the word after the kind, where it is on the same line
    std::vector<std::string_view> words_;
    std::vector<std::uint32_t> face_;
};

} // namespace

RawMesh read_off(const std::string& bytes, const std::string& name)
{
    if (bytes.empty()) throw FileError(fmt::format("{}: the file is empty", name));
    return OffReader(bytes, name).run();
}

} // namespace firsthit
