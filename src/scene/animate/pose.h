// pose.h - a scene at a time, for those who keep their threads from frame to frame.
#pragma once

#include "base/tasks.h"

#include <firsthit/scene.h>

#include <memory>

namespace firsthit {

/// As pose() of scene.h, on threads that the caller keeps.
void pose(std::shared_ptr<const Scene> scene, double time_s, World& world, Tasks& tasks);

} // namespace firsthit
