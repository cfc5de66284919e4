// obj_check.cpp - is an OBJ file whole? Leaves its vertices and faces.
//
// Assimp collects faces by object and material, which changes their order. It is given neither:
// who has which material is kept here, by triangle.
#include "readers/mesh/checked_mesh.h"
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

class ObjCheck {
  public:
    ObjCheck(const std::string& bytes, const std::string& name) : text_(bytes, name, true)
    {
        // Assimp wants at least 16 bytes.
        mesh_.bytes = "# vertices and faces\n";
        mesh_.bytes.reserve(bytes.size() + bytes.size() / 8);
    }

    CheckedMesh run()
    {
        while (text_.next_line()) read_statement();
        if (skipped_ > 0)
            mesh_.warnings.push_back(
                fmt::format("{}: {} points and lines are left out", text_.name(), skipped_));
        warn_thin_faces(thin_, text_.name(), mesh_.warnings);
        check_triangle_count(mesh_.triangle_count, text_.name());
        return std::move(mesh_);
    }

  private:
    void read_statement()
    {
        std::string_view word = text_.next_word();
        if (text_.line() == 1 && word.substr(0, 3) == "\xEF\xBB\xBF") word.remove_prefix(3);
        if (word.empty() || word[0] == '#') return;
        if (word == "v") {
            read_floats("v ", 3, 3);
            ++vertices_;
        } else if (word == "vt") {
            read_floats("vt ", 1, 2);
            ++uvs_;
        } else if (word == "vn") {
            read_floats("vn ", 3, 3);
            ++normals_;
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

    /// Reads `needed` numbers of `written`, and writes what is missing as 0. More numbers on the
    /// line (weights, colours) are left out.
    void read_floats(std::string_view keyword, int needed, int written)
    {
        static constexpr std::array<std::string_view, 3> kNames{"number 1", "number 2", "number 3"};
        mesh_.bytes += keyword;
        for (int axis = 0; axis < written; ++axis) {
            if (axis >= needed && !text_.has_word()) {
                mesh_.bytes += "0 ";
            } else {
                const float value = text_.number(kNames[static_cast<std::size_t>(axis)]);
                append_number(mesh_.bytes, text_.word(), value);
            }
        }
        mesh_.bytes.back() = '\n';
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
        mesh_.triangle_count += face_.size() - 2;
        mesh_.bytes += "f ";
        for (const Corner& corner : face_) write_corner(corner);
        mesh_.bytes.back() = '\n';
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
        corner.vertex = read_index(field(), vertices_, "vertex");
        if (const std::string_view uv = field(); !uv.empty())
            corner.uv = read_index(uv, uvs_, "texture coordinate");
        if (const std::string_view normal = field(); !normal.empty())
            corner.normal = read_index(normal, normals_, "normal");
        if (!word.empty()) text_.fail("a corner has more than v/vt/vn");
        return corner;
    }

    /// Counts from 1, or from -1 backwards.
    std::int64_t read_index(std::string_view word, std::int64_t count, const char* what) const
    {
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

    void write_corner(const Corner& corner)
    {
        std::string& out = mesh_.bytes;
        append_integer(out, corner.vertex + 1);
        if (corner.uv < 0 && corner.normal < 0) return;
        out.back() = '/';
        if (corner.uv >= 0) {
            append_integer(out, corner.uv + 1);
            if (corner.normal >= 0) out.back() = '/';
        } else {
            out += '/';
        }
        if (corner.normal >= 0) append_integer(out, corner.normal + 1);
    }

    void use_material(std::string_view name)
    {
        const auto next = static_cast<std::uint32_t>(mesh_.materials.size());
        const auto [found, added] = material_.try_emplace(std::string(name), next);
        if (added) mesh_.materials.emplace_back(name);

        // The last of several without a face between them counts.
        std::vector<MaterialRun>& runs = mesh_.material_runs;
        if (!runs.empty() && runs.back().first_triangle == mesh_.triangle_count) runs.pop_back();
        if (runs.empty() || runs.back().material != found->second)
            runs.push_back({.first_triangle = mesh_.triangle_count, .material = found->second});
    }

    CheckedMesh mesh_;
    TextCursor text_;
    std::vector<Corner> face_;
    std::unordered_map<std::string, std::uint32_t> material_;
    std::int64_t vertices_ = 0;
    std::int64_t uvs_ = 0;
    std::int64_t normals_ = 0;
    std::size_t skipped_ = 0; // points and lines
    std::size_t thin_ = 0;
};

} // namespace

CheckedMesh check_obj(std::string bytes, const std::string& name)
{
    if (bytes.empty()) throw FileError(fmt::format("{}: the file is empty", name));
    return ObjCheck(bytes, name).run();
}

} // namespace firsthit
