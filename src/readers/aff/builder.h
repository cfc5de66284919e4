// builder.h - collects what the statements of an AFF scene make.
#pragma once

#include "readers/aff/aff.h"
#include "readers/aff/lexer.h"

#include <firsthit/scene.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace firsthit::aff {

/// Triangles get their ids in the order of the calls. Neighbours of one node and material share a
/// part; equal materials are kept once.
class Builder {
  public:
    explicit Builder(const AffFiles& files);

    /// Vertices and triangles that follow belong to this node and material. `lexer` names the
    /// place.
    void begin_part(const Lexer& lexer, std::uint32_t node, std::uint32_t material);
    std::uint32_t add_vertex(const glm::vec3& position, const glm::vec3& normal);
    std::uint32_t add_vertex(
        const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv);
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

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

    /// What has only one value in a scene is written here directly.
    Scene scene;

    /// Finds tracks by their names and gives the scene away.
    Scene finish();

  private:
    Part& add_part(const Lexer& lexer, std::uint32_t node, std::uint32_t material);
    std::int32_t track_named(const std::string& name) const;

    const AffFiles& files_;
    std::map<std::array<float, 13>, std::uint32_t> materials_; // by all values and the texture
    std::unordered_map<std::string, std::int32_t> textures_;
    std::unordered_map<std::string, std::int32_t> tracks_;
    std::vector<std::pair<std::uint32_t, std::string>> node_tracks_;
    std::vector<std::pair<std::size_t, std::string>> light_tracks_;
};

} // namespace firsthit::aff
