// read_obj.cpp - OBJ files: vertices and faces, and who has which material.
#include "readers/mesh/raw_mesh.h"
#include "io/text_cursor.h"
#include "io/parse_number.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

namespace firsthit {
namespace {

// Statements that make no triangles: names, smoothing, display, free-form curves and surfaces.
constexpr auto kIgnored = std::to_array<std::string_view>({"o", "g", "s", "mg", "usemap", "maplib",
    "shadow_obj", "trace_obj", "bevel", "c_interp", "d_interp", "lod", "vp", "cstype", "deg",
    "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp", "end", "con",
    "ctech", "stech", "call", "csh", "bsp", "bzp", "cdc", "cdp", "res"});

/// One corner of a face; 0-based, -1 where it has none.
struct Corner {
    std::int64_t vertex = -1;
    std::int64_t uv = -1;
    std::int64_t normal = -1;
};

class ObjReader {
  public:
    ObjReader(const std::string& bytes, const std::string& name) : text_(bytes, name, true) {}

    RawMesh run()
    {
        while (text_.next_line()) read_statement();
        if (skipped_ > 0)
            mesh_.warnings.push_back(
                fmt::format("{}: {} points and lines are left out", text_.name(), skipped_));
        warn_thin_faces(thin_, text_.name(), mesh_.warnings);
        check_triangle_count(mesh_.index.size(), text_.name());
        if (has_uv_)
            mesh_.uv.emplace_back(0); // of corners that have none
        else
            mesh_.uv.clear();
        if (has_normal_)
            mesh_.normal.emplace_back(0);
        else
            mesh_.normal.clear();
        name_none(mesh_.uv_index, mesh_.uv.size());
        name_none(mesh_.normal_index, mesh_.normal.size());
        return std::move(mesh_);
    }

  private:
    void read_statement()
    {
        std::string_view word = text_.next_word();
        if (text_.line() == 1 && word.substr(0, 3) == "\xEF\xBB\xBF") word.remove_prefix(3);
        if (word.empty() || word[0] == '#') return;
        if (word == "v") {
            read_floats(3, 3);
            mesh_.position.push_back(numbers_);
        } else if (word == "vt") {
            read_floats(1, 2);
            mesh_.uv.emplace_back(numbers_);
        } else if (word == "vn") {
            read_floats(3, 3);
            mesh_.normal.push_back(numbers_);
        } else if (word == "f" || word == "fo") {
            read_face();
        } else if (word == "usemtl") {
            use_material(text_.rest_of_line());
        } else if (word == "mtllib") {
            mesh_.material_files.emplace_back(text_.rest_of_line());
        } else if (word == "p" || word == "l") {
            ++skipped_;
        } else if (std::find(kIgnored.begin(), kIgnored.end(), word) == kIgnored.end()) {
            text_.fail(fmt::format("'{}' is no statement of an OBJ file", printable(word)));
        }
    }

    /// Reads `wanted` numbers, of which `needed` must be there and the others are 0. More numbers on
    /// the line (weights, colours) are left out.
    void read_floats(int needed, int wanted)
    {
        static constexpr std::array<std::string_view, 3> kNames{"number 1", "number 2", "number 3"};
        for (int axis = 0; axis < wanted; ++axis)
            numbers_[axis] = axis >= needed && !text_.has_word()
                                 ? 0.0f
                                 : text_.number(kNames[static_cast<std::size_t>(axis)]);
    }

    void read_face()
    {
        face_.clear();
        while (!text_.next_word().empty() && text_.word()[0] != '#') {
            if (face_.size() == static_cast<std::size_t>(kMaxCorners))
                text_.fail(fmt::format("a face has more than {} corners", kMaxCorners));
            face_.push_back(read_corner(text_.word()));
            const Corner& first = face_.front();
            if ((face_.back().uv < 0) != (first.uv < 0) ||
                (face_.back().normal < 0) != (first.normal < 0))
                text_.fail(fmt::format(
                    "corner '{}' has another form than the face's first", printable(text_.word())));
        }
        if (face_.size() < 3) {
            ++thin_;
            return;
        }
        add_fan(mesh_.index, &Corner::vertex);
        if (has_uv_ || face_.front().uv >= 0) add_rest(mesh_.uv_index, &Corner::uv, has_uv_);
        if (has_normal_ || face_.front().normal >= 0)
            add_rest(mesh_.normal_index, &Corner::normal, has_normal_);
    }

    void add_fan(std::vector<glm::uvec3>& index, std::int64_t Corner::*what)
    {
        const auto number = [&](std::size_t k) {
            return static_cast<std::uint32_t>(face_[k].*what); // -1 becomes kNone
        };
        for (std::size_t k = 2; k < face_.size(); ++k)
            index.emplace_back(number(0), number(k - 1), number(k));
    }

    /// Numbers that triangles before the first face with any lack.
    void add_rest(std::vector<glm::uvec3>& index, std::int64_t Corner::*what, bool& has)
    {
        if (!has) index.resize(mesh_.index.size() - (face_.size() - 2), glm::uvec3(kNone));
        has = true;
        add_fan(index, what);
    }

    /// Where there is none it is the last value.
    static void name_none(std::vector<glm::uvec3>& index, std::size_t values)
    {
        for (glm::uvec3& corners : index)
            for (int k = 0; k < 3; ++k)
                if (corners[k] == kNone) corners[k] = static_cast<std::uint32_t>(values - 1);
    }

    /// "v", "v/vt", "v//vn" or "v/vt/vn"
    Corner read_corner(std::string_view word) const
    {
        const auto field = [&] {
            const std::size_t slash = std::min(word.find('/'), word.size());
            const std::string_view text = word.substr(0, slash);
            word.remove_prefix(std::min(slash + 1, word.size()));
            return text;
        };
        Corner corner;
        corner.vertex = read_index(field(), mesh_.position.size(), "vertex");
        if (const std::string_view uv = field(); !uv.empty())
            corner.uv = read_index(uv, mesh_.uv.size(), "texture coordinate");
        if (const std::string_view normal = field(); !normal.empty())
            corner.normal = read_index(normal, mesh_.normal.size(), "normal");
        if (!word.empty()) text_.fail("a corner has more than v/vt/vn");
        return corner;
    }

    /// Counts from 1, or from -1 backwards.
    std::int64_t read_index(std::string_view word, std::size_t values, const char* what) const
    {
        const auto count = static_cast<std::int64_t>(values);
        const std::optional<std::int64_t> found = parse_integer(word);
        if (!found)
            text_.fail(
                fmt::format("{} index is '{}', a whole number is needed", what, printable(word)));
        const std::int64_t index = *found;
        if (index == 0 || index > count || index < -count)
            throw SceneError(fmt::format("{}:{}: {} index {} is out of range ({} so far)",
                text_.name(), text_.line(), what, index, count));
        return index > 0 ? index - 1 : count + index;
    }

    void use_material(std::string_view name)
    {
        const auto next = static_cast<std::uint32_t>(mesh_.materials.size());
        const auto [found, added] = material_.try_emplace(std::string(name), next);
        if (added) mesh_.materials.emplace_back(name);

        // The last of several without a face between them counts.
        std::vector<MaterialRun>& runs = mesh_.material_runs;
        if (!runs.empty() && runs.back().first_triangle == mesh_.index.size()) runs.pop_back();
        if (runs.empty() || runs.back().material != found->second)
            runs.push_back({.first_triangle = mesh_.index.size(), .material = found->second});
    }

    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    RawMesh mesh_;
    TextCursor text_;
    glm::vec3 numbers_{0}; // of the line
    std::vector<Corner> face_;
    std::unordered_map<std::string, std::uint32_t> material_;
    bool has_uv_ = false; // a face has
    bool has_normal_ = false;
    std::size_t skipped_ = 0; // points and lines
    std::size_t thin_ = 0;
};

} // namespace

RawMesh read_obj(const std::string& bytes, const std::string& name)
{
    if (bytes.empty()) throw FileError(fmt::format("{}: the file is empty", name));
    return ObjReader(bytes, name).run();
}

} // namespace firsthit
