// parser.cpp - reads the statements of AFF scenes: files inside files, transforms inside
// transforms.
//
// Nothing here calls itself: open files and open braces are on stacks of their own, so that depth
// costs memory only.
#include "readers/aff/aff.h"
#include "readers/aff/statements.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace firsthit {
namespace aff {
namespace {

// Stops files that include each other twice, twice, twice ...
constexpr std::size_t kMaxIncludes = 100'000;

// Bytes. A keyword; what is longer is none of this format's.
constexpr std::size_t kLongestWord = 32;

using Read = void (*)(Lexer&, State&);

/// The statements that concern neither files nor braces.
const std::unordered_map<std::string_view, Read>& statements()
{
    static const std::unordered_map<std::string_view, Read> table = {
        {"v", read_view},
        {"l", read_light},
        {"la", read_moving_light},
        {"b", read_background},
        {"am", read_ambient},
        {"a", read_animation},
        {"d", read_detail},
        {"f", read_simple_material},
        {"fm", read_full_material},
        {"s", read_sphere},
        {"c", read_cone},
        {"p", read_polygon},
        {"pp", read_smooth_polygon},
        {"tpp", read_smooth_polygon}, // its texture coordinates are left out
        {"tet", read_tetrahedron},
        {"hex", read_cube},
        {"oct", read_octahedron},
        {"dod", read_dodecahedron},
        {"tt", read_textured_triangle},
        {"ttp", read_textured_smooth_triangle},
        {"tpa", read_animated_triangle},
        {"m", read_mesh},
        {"k", read_track},
    };
    return table;
}

/// The name under which a file is known, so that ./a.aff is a.aff.
std::string normal_name(std::string_view name)
{
    return std::filesystem::path(name).lexically_normal().string();
}

glm::dmat4 read_transform(Lexer& lexer)
{
    const glm::dvec3 scale = lexer.small_triple("the transform's scale");
    const glm::dvec3 axis = lexer.small_triple("the transform's axis");
    const double angle_rad = glm::radians(double(lexer.small_number("the transform's angle")));
    const glm::dvec3 shift = lexer.small_triple("the transform's translation");
    if (axis == glm::dvec3(0) && angle_rad != 0)
        lexer.fail_scene("the transform turns about an axis of length 0");
    glm::dmat4 matrix = glm::translate(glm::dmat4(1.0), shift);
    if (angle_rad != 0) matrix = glm::rotate(matrix, angle_rad, axis);
    return glm::scale(matrix, scale);
}

class Parser {
  public:
    Parser(const std::string& name, std::string_view text, const AffFiles& files,
        const LoadSettings& settings, std::vector<AffMeshRange>* meshes)
        : files_(files),
          state_(files, name, settings, meshes)
    {
        // Included names are relative to the main file's folder.
        open_file(name, std::filesystem::path(name).filename().string(), text);
    }

    Scene parse()
    {
        if (open_.back().lexer.peek().empty())
            open_.back().lexer.fail_file("the file has no statement");
        while (!open_.empty()) {
            Lexer& lexer = open_.back().lexer;
            const std::string_view keyword = lexer.next();
            const bool first = !std::exchange(began_, true);
            const auto known = statements().find(keyword);
            if (keyword.empty())
                close_file();
            else if (known != statements().end())
                known->second(lexer, state_);
            else if (keyword == "x" || keyword == "xs")
                open_transform(lexer, keyword == "x");
            else if (keyword == "}")
                close_transform(lexer);
            else if (keyword == "i")
                include(lexer);
            else
                leave_out(lexer, keyword, first);
        }
        check_camera();
        // Such a file is likely to be none of this format.
        if (!state_.builder.has_triangles() && !first_unknown_.empty())
            throw FileError(first_unknown_);
        return state_.builder.finish();
    }

  private:
    struct OpenFile {
        std::string key; // its normal name
        Lexer lexer;
        std::size_t outer_braces; // open when it began
    };
    struct OpenBrace {
        std::uint32_t outer_node;
        std::size_t line;
    };

    /// Leaves out a statement that nobody knows, with the rest of its line; numbers and braces at the place of
    /// a statement show that what is before them was not understood.
    void leave_out(Lexer& lexer, std::string_view keyword, bool first)
    {
        const std::string unknown = lexer.place() + "there is no statement " + in_quotes(keyword);
        // NFF of Sense8's WorldToolKit begins with that word and its version.
        if (first && keyword == "nff")
            lexer.fail_file("this is NFF of WorldToolKit, another format of that name; Haines's "
                            "Neutral File Format is read");
        const bool is_word = std::all_of(keyword.begin(), keyword.end(), [](char c) {
            return '!' <= c && c <= '~';
        }) && std::any_of(keyword.begin(), keyword.end(), [](char c) {
            return std::isalpha(static_cast<unsigned char>(c)) != 0;
        }) && keyword.size() <= kLongestWord;
        if (!is_word) throw FileError(unknown);
        if (first_unknown_.empty()) first_unknown_ = unknown;
        state_.builder.problems.add(
            "statements that nobody knows are left out with the rest of their lines",
            in_quotes(keyword) + " in line", lexer.line());
        while (lexer.has_more_on_line()) lexer.next();
    }

    void open_file(const std::string& name, const std::string& key, std::string_view text)
    {
        open_.push_back({normal_name(key), Lexer(name, text), braces_.size()});
        open_names_.insert(open_.back().key);
    }

    void close_file()
    {
        const OpenFile& file = open_.back();
        if (braces_.size() > file.outer_braces)
            file.lexer.fail_file("the file ends before the '{' of line " +
                                 std::to_string(braces_.back().line) + " is closed");
        open_names_.erase(file.key);
        open_.pop_back();
    }

    void open_transform(Lexer& lexer, bool animated)
    {
        Node node;
        node.parent = static_cast<std::int32_t>(state_.node);
        std::string_view track;
        if (animated) {
            track = lexer.word("the transform's name");
            node.name = track;
        } else
            node.local = read_transform(lexer);
        lexer.expect("{", animated ? "x" : "xs");
        braces_.push_back({state_.node, lexer.line()});
        state_.node = state_.builder.add_node(std::move(node), track);
    }

    void close_transform(const Lexer& lexer)
    {
        if (braces_.size() == open_.back().outer_braces) lexer.fail_file("a '}' without its '{'");
        state_.node = braces_.back().outer_node;
        braces_.pop_back();
    }

    void include(Lexer& lexer)
    {
        const std::int64_t level = lexer.integer("the include's detail level");
        const std::string name(lexer.word("the included file's name"));
        if (level > state_.detail) return;
        if (++includes_ > kMaxIncludes)
            lexer.fail_file("more than " + std::to_string(kMaxIncludes) + " included files");
        const std::string key = normal_name(name);
        if (open_names_.contains(key)) lexer.fail_file("recursive include: " + chain_to(key));
        open_file(name, key, included_text(lexer, name));
    }

    /// Small files are included many times: each is read once.
    std::string_view included_text(const Lexer& lexer, const std::string& name)
    {
        const auto known = texts_.find(name);
        if (known != texts_.end()) return *known->second;
        try {
            const auto entry = texts_.emplace(
                name, std::make_unique<const std::string>(files_.include_text(name)));
            return *entry.first->second;
        } catch (const FileError& error) {
            lexer.fail_file("cannot include " + in_quotes(name) + ": " + error.what());
        }
    }

    /// "a.aff -> b.aff -> a.aff", with its middle left out where it is long.
    std::string chain_to(const std::string& key) const
    {
        constexpr std::size_t kShown = 8;
        std::size_t first = open_.size();
        while (first > 0 && open_[first - 1].key != key) --first;
        std::string chain;
        for (std::size_t k = first > 0 ? first - 1 : 0; k < open_.size(); ++k) {
            const std::size_t place = k + 1 - first;
            const bool shown = place < kShown || k + kShown > open_.size();
            if (shown) chain += open_[k].key + " -> ";
            if (place == kShown && !shown) chain += "... -> ";
        }
        return chain + key;
    }

    /// A camera must look somewhere, unless a track says where.
    void check_camera() const
    {
        if (!state_.builder.camera) return;
        const Track* track = state_.builder.track_named("camera");
        if (track && !track->rotation.empty()) return;
        const Camera& camera = *state_.builder.camera;
        if (camera.direction == glm::dvec3(0))
            throw SceneError(
                state_.camera_place + "the camera's 'from' and 'at' are the same point");
        if (glm::cross(camera.direction, camera.up) == glm::dvec3(0))
            throw SceneError(
                state_.camera_place + "the camera's 'up' is zero or points where it looks");
    }

    const AffFiles& files_;
    State state_;
    std::vector<OpenFile> open_;
    std::unordered_set<std::string> open_names_;
    std::vector<OpenBrace> braces_;
    std::unordered_map<std::string, std::unique_ptr<const std::string>> texts_;
    std::size_t includes_ = 0;
    bool began_ = false;        // a statement was read
    std::string first_unknown_; // a message about the first statement that nobody knows
};

} // namespace
} // namespace aff

Scene parse_aff(const std::string& name, std::string_view text, const AffFiles& files,
    const LoadSettings& settings, std::vector<AffMeshRange>* meshes)
{
    for (const int segments : {settings.sphere_segments, settings.cone_segments})
        if (segments < LoadSettings::kMinSegments || segments > LoadSettings::kMaxSegments)
            throw ArgumentError(fmt::format("spheres and cones have {} to {} segments, not {}",
                LoadSettings::kMinSegments, LoadSettings::kMaxSegments, segments));
    return aff::Parser(name, text, files, settings, meshes).parse();
}

} // namespace firsthit
