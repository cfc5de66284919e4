// world.h - a scene posed at one time.
#pragma once

#include <firsthit/animation.h>
#include <firsthit/light.h>
#include <firsthit/view.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace firsthit {

struct Scene;

/// Which of a scene's poses.
struct PoseSettings {
    static constexpr std::int32_t kRest = -1; // no clip: as the scene is at rest

    double time_s = 0;     // of the clip, finite; what lies outside a channel's keys stays as there
    std::int32_t clip = 0; // of Scene::clips, or kRest; 0 also where there is no clip
    std::int32_t camera = 0; // of Scene::cameras; 0 also where there is none: see framing_camera
};

/// What pose keeps in a world from call to call, so that nothing is allocated a frame.
struct PoseMemory {
    std::vector<NodeTransform> transform;     // (nodes) at the time
    std::vector<std::int32_t> weight_channel; // (nodes) of the clip; -1 none
    std::vector<double> weight;               // a value of a channel of weights
    std::vector<std::size_t> first_weight;    // (parts) in target_weight
    std::vector<float> target_weight;         // of the morph targets of each part
    std::vector<std::size_t> first_joint;     // (skins) in joint_matrix, in joints
    std::vector<float> joint_matrix;          // (joints, 16) world_from_object, column by column
};

/// A scene posed at one time, in world space. Memory is reused from pose to pose.
struct World {
    std::shared_ptr<const Scene> scene;     // what was posed; shared, so that it lives as long
    double time_s = 0;                      // of the pose
    std::int32_t clip = 0;                  // of the pose, as PoseSettings
    std::vector<glm::vec3> position;        // (V)
    std::vector<glm::vec3> normal;          // (V) unit
    std::vector<glm::vec4> tangent;         // (V) unit in xyz; empty where the scene has none
    std::vector<Light> lights;              // world space
    Camera camera;                          // of that time
    std::vector<glm::dmat4> node_matrix;    // (nodes) world_from_node
    std::vector<std::uint8_t> node_visible; // (nodes)

    PoseMemory pose_memory;             // that pose keeps here
    std::vector<glm::dvec3> normal_sum; // memory that update_normals keeps here
};

/// Poses the scene at a time. Deterministic, whatever the number of threads; writes into `world` and
/// allocates nothing once its sizes have settled. A part of an invisible node collapses to a point,
/// which no ray hits. A scene without a camera gets framing_camera's. The world shares the scene:
/// what was posed stays valid whatever becomes of the caller's own pointer.
///
///     const auto scene = std::make_shared<const Scene>(load_scene("robots.aff"));
///     pose(scene, 0.5, world);
///
/// throws  SceneError: a posed coordinate that is not finite (names the part), an index out of range
///         ArgumentError: a time that is not finite, no scene, no such clip or camera
void pose(
    std::shared_ptr<const Scene> scene, const PoseSettings& pose, World& world, int threads = 1);

/// The same at a time of the first clip, by the first camera.
void pose(std::shared_ptr<const Scene> scene, double time_s, World& world, int threads = 1);

/// The same for a scene that is posed once: it is moved into the world.
void pose(Scene&& scene, double time_s, World& world, int threads = 1);

/// A camera that sees the whole world from the front, slightly above. See framing.h for others.
Camera framing_camera(const World& world);

/// Puts lights with `on_camera` where a camera takes them. pose does so for world.camera; whoever looks with
/// another camera calls this after pose. A camera that has no direction leaves them where they are.
void hang_lights(const Camera& camera, World& world);

/// Smallest and largest posed coordinate on each axis. An empty world gives two zeros.
std::array<glm::vec3, 2> bounds(const World& world);

} // namespace firsthit
