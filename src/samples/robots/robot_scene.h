// robot_scene.h - puts shapes, and nodes that walk, into a scene.
#pragma once

#include "samples/shapes.h"
#include "scene/animate/track.h"

#include <firsthit/scene_builder.h>

#include <string>

namespace firsthit {

/// Grows a scene of rigid shapes on nodes that tracks move.
class RobotScene {
  public:
    /// The scene's one clip runs from 0 to end_s.
    RobotScene(std::string name, double end_s, int frames);

    /// A node that stays where it is in its parent (-1: the world).
    std::int32_t add_node(std::string name, std::int32_t parent, const glm::dmat4& local);
    /// A node that a track moves.
    std::int32_t add_node(std::string name, std::int32_t parent, const Track& track);
    /// uv  as many as the shape has vertices, or none
    void add_shape(
        std::int32_t node, std::uint32_t material, Shape shape, std::vector<glm::vec2> uv = {});

    /// What all scenes have: materials, lights and so on.
    SceneBuilder& builder() { return builder_; }
    /// Gives the scene away.
    Scene build();

  private:
    SceneBuilder builder_;
    Clip clip_;
};

} // namespace firsthit
