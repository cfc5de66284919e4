// pose.h - a scene at a time, for those who keep their threads from frame to frame.
#pragma once

#include "base/tasks.h"

#include <firsthit/scene.h>

#include <memory>
#include <utility>

namespace firsthit {

/// As pose() of scene.h, on threads that the caller keeps.
void pose(
    std::shared_ptr<const Scene> scene, const PoseSettings& settings, World& world, Tasks& tasks);

/// The same at a time of the first clip, by the first camera.
inline void pose(std::shared_ptr<const Scene> scene, double time_s, World& world, Tasks& tasks)
{
    pose(std::move(scene), PoseSettings{.time_s = time_s}, world, tasks);
}

} // namespace firsthit
