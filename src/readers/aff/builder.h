// builder.h - collects what the statements of an AFF scene make.
#pragma once

#include "readers/aff/aff.h"
#include "readers/aff/lexer.h"
#include "readers/problems.h"
#include "scene/animate/track.h"

#include <firsthit/scene_builder.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace firsthit::aff {

/// Triangles get their ids in the order of the calls. Neighbours of one node and material share a
/// instance; equal materials are kept once.
class Builder {
  public:
    /// name  of the scene, for messages
    Builder(const AffFiles& files, const std::string& name);

    /// Vertices and triangles that follow belong to this node and material. `lexer` names the
    /// place.
    void begin_instance(const Lexer& lexer, std::uint32_t node, std::uint32_t material);
    /// returns  its number: those of a scene are consecutive
    std::uint32_t add_vertex(const glm::vec3& position, const glm::vec3& normal);
    std::uint32_t add_vertex(
        const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv);
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    /// How many vertices were added, which is the number of the next one.
    std::uint32_t vertices() const;
    bool has_triangles() const;

    /// One triangle whose shape changes. keys have three vertices each.
    void add_morph_triangle(const Lexer& lexer, std::uint32_t node, std::uint32_t material,
        const std::vector<MorphKey>& keys);

    /// The number of the material that is `phong` with a texture (-1 none).
    /// name  that it gets if it is new
    std::uint32_t material(const std::string& name, const Phong& phong, std::int32_t texture);
    /// The number of a texture, or -1 and a warning, once a file, where it cannot be read.
    std::int32_t texture(const Lexer& lexer, std::string_view name);

    /// track  the name of the track that moves it, or empty
    std::uint32_t add_node(Node node, std::string_view track);
    void add_light(const Light& light, std::string_view track);
    /// An empty track of this name, in place of an earlier one.
    Track& begin_track(std::string_view name);

    void warn(const Lexer& lexer, const std::string& message);
    /// What is left out, counted; finish() makes warnings of it.
    Problems problems;

    SceneBuilder scene;           // what has only one value is set here directly
    std::optional<Camera> camera; // of the `v`
    Clip clip;                    // its range; finish() adds the channels of all tracks

    /// The track of this name, or null.
    const Track* track_named(const std::string& name) const;

    /// Finds tracks by their names and gives the scene away.
    Scene finish();

  private:
    /// A mesh that will be an instance.
    struct Part {
        std::string place; // of its statement
        std::uint32_t node = 0;
        std::uint32_t material = 0;
        std::uint32_t first_vertex = 0;
        Mesh mesh{};
    };

    Part& add_part(const Lexer& lexer, std::uint32_t node, std::uint32_t material);
    std::uint32_t track_node(const Track& track, NodeTransform rest);
    void add_camera();

    const AffFiles& files_;
    std::string name_;
    std::vector<Part> parts_;
    std::vector<Node> nodes_;
    std::vector<Light> lights_;
    std::vector<std::string> texture_names_;
    std::map<std::array<float, 13>, std::uint32_t> materials_; // by all values and the texture
    std::unordered_map<std::string, std::int32_t> textures_;
    std::unordered_map<std::string, Track> tracks_;
    std::vector<std::pair<std::uint32_t, std::string>> node_tracks_;
    std::vector<std::pair<std::size_t, std::string>> light_tracks_;
};

} // namespace firsthit::aff
