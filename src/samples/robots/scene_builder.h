// scene_builder.h - puts nodes, tracks and shapes together to a scene.
#pragma once

#include "samples/robots/shapes.h"

#include <firsthit/scene.h>

#include <string>

namespace firsthit {

/// Grows a scene of rigid parts. Numbers are those of the scene's arrays.
class SceneBuilder {
  public:
    explicit SceneBuilder(std::string name) { scene_.name = std::move(name); }

    std::uint32_t add_material(Material material);
    std::int32_t add_track(Track track);
    /// A node that stays where it is in its parent.
    std::int32_t add_node(std::string name, std::int32_t parent, const glm::dmat4& local);
    /// A node that a track moves.
    std::int32_t add_node(std::string name, std::int32_t parent, Track track);
    /// uv  as many as the shape has vertices, or none
    void add_part(
        std::int32_t node, std::uint32_t material, Shape shape, std::vector<glm::vec2> uv = {});

    Scene& scene() { return scene_; }
    Scene take() { return std::move(scene_); }

  private:
    Scene scene_;
};

} // namespace firsthit
