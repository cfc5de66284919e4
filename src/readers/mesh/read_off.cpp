// read_off.cpp - Object File Format: Geomview's text files of vertices and polygons.
#include "readers/mesh/raw_mesh.h"
#include "readers/mesh/triangulate_polygon.h"

#include "base/srgb.h"
#include "io/parse_number.h"
#include "io/text_cursor.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace firsthit {
namespace {

/// What the file's first word says of its vertices.
struct OffKind {
    bool uv = false, color = false, normal = false;
};

/// "OFF", with ST, C and N in front of it, in any case; nothing where the word is another.
/// word  becomes what stands behind it
std::optional<OffKind> take_kind(std::string_view& word)
{
    const auto take = [&word](std::string_view prefix) {
        const std::string_view first = word.substr(0, prefix.size());
        const bool has = std::equal(first.begin(), first.end(), prefix.begin(), prefix.end(),
            [](char a, char b) { return std::toupper(static_cast<unsigned char>(a)) == b; });
        if (has) word.remove_prefix(prefix.size());
        return has;
    };
    OffKind kind;
    kind.uv = take("ST");
    kind.color = take("C");
    kind.normal = take("N");
    if (!take("OFF")) return std::nullopt;
    return kind;
}

/// Thrown where the file ends, with what is missing.
struct OffEnds {
    std::string what;
};

/// Colours are displayed values: whole numbers up to 255, or others up to 1. The alpha is a share. What is
/// no number is not finite.
glm::vec4 color_of(const std::vector<std::string_view>& words)
{
    const bool whole = std::all_of(words.begin(), words.end(),
        [](std::string_view word) { return word.find_first_of(".eE") == std::string_view::npos; });
    glm::vec4 color(1);
    for (std::size_t k = 0; k < std::min<std::size_t>(words.size(), 4); ++k) {
        const std::optional<float> value = parse_float(words[k]);
        if (!value || !std::isfinite(*value)) return glm::vec4(NAN);
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
        try {
            read_kind();
            vertices_ = count("number of vertices");
            const auto faces = count("number of faces");
            ahead_ = word_on_line(); // the number of edges, if it is there
            if (!ahead_.empty()) (void)count("number of edges");
            ahead_ = {};
            for (std::size_t v = 0; v < vertices_; ++v) read_vertex();
            read_faces(faces);
        } catch (const OffEnds& end) {
            text_.fail(fmt::format("the file ends where there should be: {}", end.what));
        }
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
            if (!text_.next_line()) throw OffEnds{std::string(what)};
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
        std::string_view rest = first;
        const std::optional<OffKind> kind = take_kind(rest);
        if (kind) kind_ = *kind;
        // The word may be missing, or joined to the number of vertices: "OFF490 518 0".
        if (!kind) rest = first;
        if ((!kind || !rest.empty()) && !parse_integer(rest))
            text_.fail(
                fmt::format("'{}' is no kind of OFF file that is read: accepted are OFF, with "
                            "ST, C and N in front (no 4OFF, nOFF)",
                    printable(first)));
        if (!kind) mesh_.problems.add("the word OFF is missing", "line", text_.line());
        ahead_ = rest.empty() ? word_on_line() : rest;
        // "OFF BINARY" would be followed by numbers that are no text.
        if (ahead_ == "BINARY") text_.fail("binary OFF files are not read");
    }

    std::string_view next(std::string_view what)
    {
        return ahead_.empty() ? word(what) : std::exchange(ahead_, {});
    }

    /// Every vertex takes at least six bytes.
    std::size_t count(std::string_view what)
    {
        const std::string_view text = next(what);
        const std::optional<std::int64_t> number = parse_integer(text);
        if (!number || *number < 0)
            text_.fail(fmt::format("{} is '{}', a whole number is needed", what, printable(text)));
        if (static_cast<std::uint64_t>(*number) > bytes_ && what == "number of vertices")
            text_.fail(fmt::format(
                "{} is {}, more than a file of {} bytes can have", what, *number, bytes_));
        return static_cast<std::size_t>(*number);
    }

    /// May be not finite: whoever needs it is left out later.
    float number(std::string_view what)
    {
        const std::string_view text = word(what);
        const std::optional<float> value = parse_float(text);
        if (value) return *value;
        if (!says_no_number(text))
            text_.fail(fmt::format("{} is '{}', a number is needed", what, printable(text)));
        return NAN;
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
        if (!kind_.color && !kind_.uv) {
            leave_out_spare_numbers();
            return;
        }
        std::vector<std::string_view> rest = words_on_line();
        if (kind_.uv) {
            const std::size_t uv = rest.size() < 2 ? rest.size() : rest.size() - 2;
            const bool has = uv + 1 < rest.size();
            const std::optional<float> u = has ? parse_float(rest[uv]) : std::nullopt;
            const std::optional<float> v = has ? parse_float(rest[uv + 1]) : std::nullopt;
            if (!has) add_problem("texture coordinates that are missing are 0");
            const float none = has ? NAN : 0.0f;
            mesh_.uv.emplace_back(u.value_or(none), v.value_or(none));
            rest.resize(uv);
        }
        if (!kind_.color) return;
        if (rest.size() < 3) add_problem("colours of fewer than three numbers are white");
        mesh_.color.push_back(rest.size() < 3 ? glm::vec4(1) : color_of(rest));
    }

    /// Some programs write colours behind positions and do not say so.
    void leave_out_spare_numbers()
    {
        if (mesh_.position.size() == 1) has_spare_ = has_spare_numbers(text_);
        if (has_spare_ && !words_on_line().empty())
            add_problem("spare numbers of vertices are left out");
    }

    /// Whether each vertex is a line, with three or four numbers more than it needs.
    /// ahead  behind the first vertex
    bool has_spare_numbers(TextCursor ahead) const
    {
        const std::size_t spare = count_words(ahead);
        if (spare != 3 && spare != 4) return false;
        const std::size_t needed = kind_.normal ? 6 : 3;
        for (std::size_t v = 1; v < vertices_; ++v) {
            std::size_t words = 0;
            while (words == 0 && ahead.next_line()) words = count_words(ahead);
            if (words != needed + spare) return false;
        }
        return true;
    }

    /// Words on the line that are no comment.
    static std::size_t count_words(TextCursor& line)
    {
        std::size_t words = 0;
        for (std::string_view w = line.next_word(); !w.empty() && w[0] != '#'; w = line.next_word())
            ++words;
        return words;
    }

    void read_faces(std::size_t faces)
    {
        std::size_t face = 0;
        try {
            for (; face < faces; ++face) read_face();
        } catch (const OffEnds&) {
            if (mesh_.index.empty()) throw;
            mesh_.problems.add(
                fmt::format("the file ends at face {} of {}: the rest is missing", face, faces));
            return;
        }
        try {
            (void)word("");
            add_problem("words behind the last face are left out");
        } catch (const OffEnds&) {
            // So it should be.
        }
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
        outline_.clear();
        triangles_.clear();
        for (const std::uint32_t v : face_) outline_.push_back(mesh_.position[v]);
        if (!triangulate_polygon(outline_, triangles_))
            add_problem("faces whose outline crosses itself are cut as well as may be");
        if (rest.size() >= 3) mesh_.triangle_color.resize(mesh_.index.size(), glm::vec4(1));
        for (const glm::uvec3& t : triangles_)
            mesh_.index.emplace_back(face_[t.x], face_[t.y], face_[t.z]);
        if (rest.size() >= 3)
            mesh_.triangle_color.resize(mesh_.index.size(), color_of(rest));
        else if (!mesh_.triangle_color.empty())
            mesh_.triangle_color.resize(mesh_.index.size(), glm::vec4(1));
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

    void add_problem(std::string_view kind) { mesh_.problems.add(kind, "line", text_.line()); }

    RawMesh mesh_;
    TextCursor text_;
    std::size_t bytes_;
    std::size_t vertices_ = 0;
    bool started_ = false; // on a line
    OffKind kind_;
    std::string_view ahead_; // the word after the kind, where it is on the same line
    std::vector<std::string_view> words_;
    std::vector<std::uint32_t> face_;
    std::vector<glm::vec3> outline_; // of the face
    std::vector<glm::uvec3> triangles_;
    bool has_spare_ = false; // numbers behind each vertex that nothing announces
};

} // namespace

RawMesh read_off(const std::string& bytes, const std::string& name)
{
    if (bytes.empty()) throw FileError(fmt::format("{}: the file is empty", name));
    return OffReader(bytes, name).run();
}

} // namespace firsthit
