// pose_nodes.h - where the nodes, joints, lights and the camera of a scene are at a time.
#pragma once

#include "base/tasks.h"

#include <firsthit/scene.h>

#include <cstdint>

namespace firsthit {

/// Fills what a world says of nodes, and in its memory the matrices of joints and the weights of morph
/// targets, at world.time_s. The scene has the shape that pose() checks.
///
/// clip  null: at rest
void pose_nodes(const Scene& scene, const Clip* clip, World& world, Tasks& tasks);

/// Where the matrices of joints begin: 16 floats of one are 64 bytes of one cache line.
inline float* joint_matrices(PoseMemory& memory)
{
    constexpr std::uintptr_t kLine = 64;
    const auto begin = reinterpret_cast<std::uintptr_t>(memory.joint_matrix.data());
    return reinterpret_cast<float*>((begin + kLine - 1) / kLine * kLine);
}

/// The lights, after the nodes.
void pose_lights(const Scene& scene, World& world);

/// The camera, after the nodes and vertices.
///
/// camera  of Scene::cameras; where there is none the camera frames the whole world
void pose_camera(const Scene& scene, std::int32_t camera, World& world);

} // namespace firsthit
