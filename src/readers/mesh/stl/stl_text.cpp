// stl_text.cpp - STL files that are text.
#include "readers/mesh/stl/stl_text.h"
#include "io/parse_number.h"
#include "io/text_cursor.h"
#include "io/token_reader.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace firsthit {
namespace {

constexpr std::string_view kBom = "\xEF\xBB\xBF";
constexpr std::size_t kFirstBytes =
    256; // in which a binary file has a zero: in its count, at least
constexpr std::size_t kCommentBytes = 4096; // in which the first facet begins

bool same_word(std::string_view word, std::string_view lower)
{
    return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
        [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

/// A number with a decimal comma.
std::optional<float> with_point(std::string_view word)
{
    std::string changed(word);
    std::replace(changed.begin(), changed.end(), ',', '.');
    return parse_float(changed);
}

std::size_t bom_size(const std::string& bytes)
{
    return bytes.compare(0, kBom.size(), kBom) == 0 ? kBom.size() : 0;
}

class StlText {
  public:
    StlText(std::string_view text, const std::string& name) : text_(text, name), name_(name) {}

    RawMesh read()
    {
        while (text_.has_word()) {
            const std::string_view word = text_.next_word();
            if (same_word(word, "vertex"))
                add_corner();
            else if (same_word(word, "facet"))
                end_facet();
            else if (same_word(word, "normal"))
                skip_normal();
            else if (same_word(word, "endfacet") || same_word(word, "endloop"))
                end_facet();
            else if (same_word(word, "solid"))
                begin_solid();
            else if (same_word(word, "endsolid"))
                end_solid();
            else if (!same_word(word, "outer") && !same_word(word, "loop"))
                mesh_.problems.add("unknown words are left out", "byte", text_.consumed());
        }
        const bool cut = in_solid_ || corners_ > 0;
        mesh_.position.resize(mesh_.position.size() - corners_);
        if (cut && mesh_.index.empty())
            throw FileError(fmt::format(
                "{}: no triangles in it: the file ends inside a solid: it is truncated", name_));
        check_triangle_count(mesh_.index.size(), name_);
        if (cut) mesh_.problems.add("the file ends inside a solid: the rest is missing");
        return std::move(mesh_);
    }

  private:
    void add_corner()
    {
        glm::vec3& position = mesh_.position.emplace_back();
        ++corners_;
        for (int axis = 0; axis < 3; ++axis) {
            if (!text_.has_word()) return; // the file ends: the facet is left out
            position[axis] = coordinate(axis);
        }
    }

    float coordinate(int axis)
    {
        TokenReader ahead = text_;
        const std::string_view word = ahead.next_word();
        const bool is_none = says_no_number(word);
        std::optional<float> decimal;
        if (!is_none && word.find(',') != word.npos) decimal = with_point(word);
        if (!is_none && !decimal)
            return text_.number(std::string_view("xyz").substr(std::size_t(axis), 1));
        if (decimal)
            mesh_.problems.add("commas in numbers are decimal points", "byte", text_.consumed());
        text_ = ahead;
        return decimal.value_or(std::numeric_limits<float>::quiet_NaN());
    }

    /// Normals are not used, and exporters write some that are no numbers.
    void skip_normal()
    {
        for (int k = 0; k < 3; ++k) {
            TokenReader ahead = text_;
            const std::string_view word = ahead.next_word();
            if (same_word(word, "outer") || same_word(word, "vertex")) return;
            text_ = ahead;
        }
    }

    void end_facet()
    {
        if (corners_ == 0) return;
        const auto first = static_cast<std::uint32_t>(mesh_.position.size() - corners_);
        if (corners_ < 3) {
            mesh_.problems.add(kThinFaces, "triangle", mesh_.index.size());
            mesh_.position.resize(first);
        }
        if (corners_ > 3)
            mesh_.problems.add(
                "facets of more than 3 corners are cut", "triangle", mesh_.index.size());
        for (std::uint32_t k = 2; k < corners_; ++k)
            mesh_.index.emplace_back(first, first + k - 1, first + k);
        corners_ = 0;
    }

    void begin_solid()
    {
        end_facet();
        in_solid_ = true;
        TokenReader ahead = text_;
        line_of_solid_ = ahead.rest_of_line();
        std::string name = read_name({"facet"});
        if (!mesh_.runs.empty() && mesh_.runs.back().first_triangle == mesh_.index.size())
            mesh_.runs.pop_back(); // of a solid without facets
        mesh_.runs.push_back({.first_triangle = mesh_.index.size(), .name = std::move(name)});
    }

    void end_solid()
    {
        end_facet();
        in_solid_ = false;
        // A name may hold any words: the same one needs no look at them.
        TokenReader ahead = text_;
        if (ahead.rest_of_line() == line_of_solid_)
            text_ = ahead;
        else
            read_name({"facet", "solid"});
    }

    /// A name ends with its line, or before one of the words on it.
    std::string read_name(std::initializer_list<std::string_view> stops)
    {
        TokenReader ahead = text_;
        TokenReader words(ahead.rest_of_line(), name_);
        std::string name;
        while (words.has_word()) {
            const std::string_view word = words.next_word();
            if (std::any_of(stops.begin(), stops.end(),
                    [&](std::string_view stop) { return same_word(word, stop); })) {
                text_.seek(static_cast<std::size_t>(word.data() - text_.text().data()));
                return name;
            }
            if (!name.empty()) name += ' ';
            name += word;
        }
        text_ = ahead;
        return name;
    }

    TokenReader text_;
    const std::string& name_;
    RawMesh mesh_;
    std::uint32_t corners_ = 0; // of the facet that is read
    bool in_solid_ = false;
    std::string_view line_of_solid_; // what stands behind the word
};

} // namespace

bool is_stl_text(const std::string& bytes)
{
    const std::string_view text = std::string_view(bytes).substr(bom_size(bytes));
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return false;
    const std::string_view word = text.substr(first, 5);
    if (text.substr(0, kFirstBytes).find('\0') != std::string_view::npos) return false;
    if (same_word(word, "solid") || same_word(word, "facet")) return true;
    // Behind comments of programs that write some.
    const std::string_view begin = text.substr(0, kCommentBytes);
    return begin.find("facet") != begin.npos && begin.find("vertex") != begin.npos;
}

RawMesh read_stl_text(const std::string& bytes, const std::string& name)
{
    return StlText(std::string_view(bytes).substr(bom_size(bytes)), name).read();
}

} // namespace firsthit
