// room_scene.h - puts the room's things together: shapes on nodes, at rest or moving.
#pragma once

#include "samples/room/materials.h"
#include "samples/shapes.h"

#include <firsthit/scene_builder.h>

#include <functional>
#include <string>
#include <vector>

namespace firsthit {

inline constexpr double kRoomEnd = 20.0; // s, of the room's one clip

/// Grows the room.
class RoomScene {
  public:
    RoomScene();

    /// The materials that all things share.
    const RoomMaterials& materials() const { return materials_; }

    /// A node that stays where it is in its parent (-1: the room).
    std::int32_t add_node(std::string name, std::int32_t parent, const glm::dmat4& local);
    /// A node that moves for the whole clip: through keys step_s apart, by cubic curves whose slopes are those
    /// between neighbouring keys (Catmull and Rom 1974), which needs no function of a C library.
    std::int32_t add_moving_node(std::string name, std::int32_t parent, double step_s,
        const std::function<NodeTransform(double time_s)>& movement);

    /// A mesh for place().
    std::uint32_t add_mesh(Shape shape, std::vector<glm::vec2> uv = {});
    /// Places a mesh, which may be placed many times.
    void place(std::uint32_t mesh, std::int32_t node, std::uint32_t material);
    /// Places a shape once.
    void add(
        std::int32_t node, std::uint32_t material, Shape shape, std::vector<glm::vec2> uv = {});

    /// What all scenes have: lights and so on.
    SceneBuilder& builder() { return builder_; }
    /// Gives the scene away.
    Scene build();

  private:
    SceneBuilder builder_;
    RoomMaterials materials_;
    Clip clip_;
};

/// A turn about an axis, which has to be a unit vector.
glm::dquat turn_about(const glm::dvec3& axis, double angle_rad);

} // namespace firsthit
