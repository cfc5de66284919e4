// read_obj.cpp - OBJ files: vertices and faces, and who has which name and material.
//
// source  Wavefront 1992, "Advanced Visualizer Manual", appendix B1, "Object Files"
#include "readers/mesh/raw_mesh.h"

#include "io/text_cursor.h"
#include "readers/mesh/obj/obj_colors.h"
#include "readers/mesh/obj/obj_faces.h"
#include "readers/mesh/obj/obj_lines.h"
#include "readers/mesh/obj/obj_numbers.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>
#include <system_error>
#include <unordered_map>
#include <utility>

namespace firsthit {
namespace {

// Statements that change nothing that is shown: display, the data of free-form geometry.
constexpr auto kIgnored = std::to_array<std::string_view>({"mg", "maplib", "usemap", "shadow_obj",
    "trace_obj", "bevel", "c_interp", "d_interp", "lod", "vp", "cstype", "deg", "bmat", "step",
    "parm", "trim", "hole", "scrv", "sp", "end", "con", "ctech", "stech"});

constexpr auto kFreeForm =
    std::to_array<std::string_view>({"curv", "curv2", "surf", "bsp", "bzp", "cdc", "cdp", "res"});

constexpr auto kUpperCase = std::to_array<std::string_view>({"V", "VN", "VT", "F"});

/// Runs that have names. Each is an instance, which takes about a kilobyte.
constexpr std::size_t kMostNamedRuns = 65536;

/// Characters of a name that are kept. Many instances may have the same one.
constexpr std::size_t kMostName = 256;

/// Kinds of unknown statements that are told of by name.
constexpr std::size_t kMostUnknown = 8;

template <std::size_t N>
bool is_one_of(std::string_view word, const std::array<std::string_view, N>& words)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjReader {
  public:
    ObjReader(std::string_view text, const std::string& name) : lines_(text), name_(name) {}

    RawMesh run()
    {
        while (lines_.next()) read_statement(lines_.statement());
        if (faces_.count() == 0)
            throw FileError(fmt::format(
                "{}: no triangles in it: {} vertices and no faces", name_, mesh_.position.size()));
        const std::vector<std::size_t> first_triangle = faces_.make_triangles(mesh_, name_);
        if (mesh_.index.empty())
            throw FileError(fmt::format("{}: no triangles in it: all have a corner that is no "
                                        "finite float",
                name_));
        check_triangle_count(mesh_.index.size(), name_);
        add_runs(first_triangle);
        colors_.finish(mesh_);
        // No triangle uses them, and nothing has to look out for them.
        for (const std::size_t vertex : not_finite_) mesh_.position[vertex] = glm::vec3(0);
        return std::move(mesh_);
    }

  private:
    void read_statement(std::string_view text)
    {
        const std::string_view word = take_obj_word(text);
        if (word.empty()) return;
        if (word == "v")
            read_vertex(text);
        else if (word == "vn")
            read_normal(text);
        else if (word == "vt")
            read_uv(text);
        else if (word == "f" || word == "fo")
            read_face(text);
        else if (word[0] == '#')
            read_comment(word, text);
        else
            read_name(word, without_blanks(text));
    }

    /// Statements of which there are few.
    void read_name(std::string_view word, std::string_view rest)
    {
        if (word == "usemtl") {
            material_ = number_of_material(rest);
            is_new_run_ = true;
        } else if (word == "g") {
            group_ = rest.substr(0, kMostName);
            is_new_run_ = true;
        } else if (word == "o") {
            object_ = rest.substr(0, kMostName);
            group_.clear();
            is_new_run_ = true;
        } else if (word == "mtllib") {
            mesh_.material_files.emplace_back(rest);
        } else if (word == "s") {
            read_smoothing(rest);
        } else if (word == "p" || word == "l") {
            add_problem("points and lines are left out");
        } else if (is_one_of(word, kFreeForm)) {
            add_problem("free-form curves and surfaces are left out");
        } else if (word == "call" || word == "csh") {
            add_problem("'call' and 'csh' are not followed");
        } else if (is_one_of(word, kUpperCase)) {
            read_upper_case(word, rest);
        } else if (!is_one_of(word, kIgnored)) {
            if (unknown_.size() < kMostUnknown) unknown_.emplace(word);
            if (unknown_.count(std::string(word)) > 0)
                add_problem(fmt::format("unknown statements '{}' are left out", printable(word)));
            else
                add_problem("other unknown statements are left out");
        }
    }

    /// "off" or a number. What is neither ends the group before it.
    void read_smoothing(std::string_view rest)
    {
        const std::string_view word = take_obj_word(rest);
        std::uint32_t group = 0;
        const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), group);
        if (word == "on") {
            group = 1;
        } else if (error != std::errc() && word != "off") {
            add_problem("smoothing groups that are neither a number nor off are left out");
            group = kNoSmoothingGroup;
        }
        faces_.set_smoothing(group);
    }

    /// Statements in capital letters, as few programs write them.
    void read_upper_case(std::string_view word, std::string_view rest)
    {
        if (word == "V")
            read_vertex(rest);
        else if (word == "VN")
            read_normal(rest);
        else if (word == "VT")
            read_uv(rest);
        else
            read_face(rest);
    }

    void read_comment(std::string_view word, std::string_view rest)
    {
        if (word == "#MRGB") colors_.add_codes(rest);
    }

    /// Three numbers, and perhaps a weight or a colour.
    void read_vertex(std::string_view text)
    {
        const ObjNumbers numbers = read_numbers(text, 3, 3);
        glm::vec3 position(numbers.value[0], numbers.value[1], numbers.value[2]);
        if (numbers.count == 0) position.x = NAN;
        if (!is_finite(numbers, 3) || numbers.count == 0) {
            add_problem("positions that are not finite numbers are left out");
            not_finite_.push_back(mesh_.position.size());
        }
        if (numbers.count >= 6) {
            glm::vec3 color(numbers.value[3], numbers.value[4], numbers.value[5]);
            if (!std::isfinite(color.r + color.g + color.b)) {
                add_problem("vertex colours that are not finite numbers are white");
                color = glm::vec3(1);
            }
            colors_.add(mesh_.position.size(), color);
        }
        mesh_.position.push_back(position);
    }

    void read_normal(std::string_view text)
    {
        const ObjNumbers numbers = read_numbers(text, 3, 3);
        const bool finite = is_finite(numbers, 3);
        if (!finite) add_problem("normals that are not finite numbers are computed");
        mesh_.normal.push_back(finite
                                   ? glm::vec3(numbers.value[0], numbers.value[1], numbers.value[2])
                                   : glm::vec3(0));
    }

    /// The second number may be missing, a third one is for textures of three dimensions.
    void read_uv(std::string_view text)
    {
        const ObjNumbers numbers = read_numbers(text, 2, 1);
        const bool finite = is_finite(numbers, 2);
        if (!finite) add_problem("texture coordinates that are not finite numbers are 0");
        mesh_.uv.push_back(finite ? glm::vec2(numbers.value[0], numbers.value[1]) : glm::vec2(0));
    }

    /// Reads as many numbers as there usually are, of which some must be there.
    ObjNumbers read_numbers(std::string_view text, std::size_t usual, std::size_t needed)
    {
        ObjNumbers numbers = read_obj_numbers(text, usual);
        if (numbers.has_comma) add_problem("commas in numbers are decimal points or blanks");
        if (numbers.count < needed) add_problem("missing coordinates are 0");
        return numbers;
    }

    static bool is_finite(const ObjNumbers& numbers, std::size_t count)
    {
        bool finite = true;
        for (std::size_t k = 0; k < count; ++k) finite &= std::isfinite(numbers.value[k]);
        return finite;
    }

    void read_face(std::string_view text)
    {
        corners_.clear();
        const char* at = text.data();
        const char* const end = at + text.size();
        for (;;) {
            while (at < end && (is_obj_blank(*at) || *at == ',')) ++at;
            if (at == end || *at == '#') break;
            if (corners_.size() == static_cast<std::size_t>(kMaxCorners))
                fail(fmt::format("a face has more than {} corners", kMaxCorners));
            corners_.push_back(read_corner(at, end));
        }
        if (corners_.size() < 3) {
            add_problem(kThinFaces);
            return;
        }
        start_run();
        faces_.add(corners_, lines_.line());
    }

    /// "v", "v/vt", "v//vn" or "v/vt/vn", up to a blank or comma.
    ObjCorner read_corner(const char*& at, const char* end)
    {
        const char* const first = at;
        const auto ends = [&] { return at == end || ends_corner(*at); };
        ObjCorner corner;
        std::int64_t index = 0;
        if (!read_index(at, end, index) || !(ends() || *at == '/')) {
            while (!ends()) ++at;
            fail(fmt::format("vertex index is '{}', a whole number is needed",
                printable({first, static_cast<std::size_t>(at - first)})));
        }
        const auto vertices = static_cast<std::int64_t>(mesh_.position.size());
        if (index == 0 || index < -vertices || index > kMostIndex)
            throw SceneError(fmt::format("{}:{}: vertex index {} is out of range ({} so far)",
                name_, lines_.line(), index, vertices));
        corner.vertex = static_cast<std::uint32_t>(index > 0 ? index - 1 : vertices + index);
        if (ends()) return corner;
        ++at;
        corner.uv =
            read_other(at, end, mesh_.uv.size(), "texture coordinates that do not exist are 0");
        if (ends()) return corner;
        ++at;
        corner.normal =
            read_other(at, end, mesh_.normal.size(), "normals that do not exist are computed");
        if (!ends()) {
            add_problem("more than v/vt/vn at a corner is left out");
            while (!ends()) ++at;
        }
        return corner;
    }

    /// The index of a value without which a corner can be shown, up to a slash or the corner's end.
    std::uint32_t read_other(
        const char*& at, const char* end, std::size_t values, std::string_view if_missing)
    {
        const auto ends = [&] { return at == end || ends_corner(*at) || *at == '/'; };
        if (ends()) return ObjCorner::kNone;
        const auto count = static_cast<std::int64_t>(values);
        std::int64_t index = 0;
        if (read_index(at, end, index) && ends() && index != 0 && index >= -count &&
            index <= kMostIndex)
            return static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index);
        while (!ends()) ++at;
        add_problem(if_missing);
        return ObjCorner::kNone;
    }

    /// returns  false where no whole number of 64 bits begins there
    static bool read_index(const char*& at, const char* end, std::int64_t& index)
    {
        if (end - at > 1 && *at == '+' && at[1] != '-') ++at;
        const auto [stop, error] = std::from_chars(at, end, index);
        at = stop;
        // Programs that print all numbers alike write "1.000000".
        if (error == std::errc() && end - at > 1 && *at == '.' && at[1] == '0')
            for (++at; at < end && *at == '0';) ++at;
        return error == std::errc();
    }

    std::uint32_t number_of_material(std::string_view name)
    {
        const auto next = static_cast<std::uint32_t>(mesh_.materials.size());
        const auto [found, added] = number_of_material_.try_emplace(std::string(name), next);
        if (added) mesh_.materials.emplace_back(name);
        return found->second;
    }

    /// Before a face: begins a run where the object, group or material changed.
    void start_run()
    {
        if (!is_new_run_) return;
        is_new_run_ = false;
        MeshRun run{.first_triangle = faces_.count(), .material = material_, .name = object_};
        if (!object_.empty() && !group_.empty()) run.name += '/';
        run.name += group_;
        if (!runs_.empty() && runs_.back().material == material_ && runs_.back().name == run.name)
            return;
        runs_.push_back(std::move(run));
    }

    /// From faces to triangles; runs of which no triangle is left are dropped.
    void add_runs(const std::vector<std::size_t>& first_triangle)
    {
        if (runs_.size() > kMostNamedRuns) drop_names();
        for (std::size_t r = 0; r < runs_.size(); ++r) {
            MeshRun& run = runs_[r];
            const std::size_t end = r + 1 < runs_.size()
                                        ? first_triangle[runs_[r + 1].first_triangle]
                                        : mesh_.index.size();
            run.first_triangle = first_triangle[run.first_triangle];
            if (run.first_triangle == end) continue;
            if (run.material == kNoMaterial)
                run.material = static_cast<std::uint32_t>(mesh_.materials.size());
            mesh_.runs.push_back(std::move(run));
        }
    }

    /// Leaves runs of the same material, each as long as it can be.
    void drop_names()
    {
        mesh_.problems.add(fmt::format(
            "more than {} objects and groups: only materials are told apart", kMostNamedRuns));
        for (MeshRun& run : runs_) run.name.clear();
        const auto same = [](const MeshRun& a, const MeshRun& b) {
            return a.material == b.material;
        };
        runs_.erase(std::unique(runs_.begin(), runs_.end(), same), runs_.end());
    }

    void add_problem(std::string_view kind) { mesh_.problems.add(kind, "line", lines_.line()); }

    [[noreturn]] void fail(const std::string& message) const
    {
        throw FileError(fmt::format("{}:{}: {}", name_, lines_.line(), message));
    }

    static bool ends_corner(char c) { return is_obj_blank(c) || c == ',' || c == '#'; }

    static constexpr std::uint32_t kNoMaterial = 0xFFFFFFFFu;
    static constexpr std::int64_t kMostIndex = 0xFFFFFFFE; // no file is long enough for more

    RawMesh mesh_;
    ObjLines lines_;
    const std::string& name_;
    ObjFaces faces_;
    ObjColors colors_;
    std::vector<ObjCorner> corners_;      // of the face
    std::vector<std::size_t> not_finite_; // positions
    std::unordered_map<std::string, std::uint32_t> number_of_material_;
    std::set<std::string> unknown_; // statements
    std::uint32_t material_ = kNoMaterial;
    std::string object_;
    std::string group_;
    std::vector<MeshRun> runs_; // of which first_triangle is a face
    bool is_new_run_ = true;
};

} // namespace

RawMesh read_obj(const std::string& bytes, const std::string& name)
{
    if (bytes.empty()) throw FileError(fmt::format("{}: the file is empty", name));
    return ObjReader(obj_text(bytes, name), name).run();
}

} // namespace firsthit
