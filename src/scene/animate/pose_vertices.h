// pose_vertices.h - where the vertices of a scene are at a time.
#pragma once

#include "base/tasks.h"

#include <firsthit/scene.h>

namespace firsthit {

/// Fills world.position, normal and tangent, after pose_nodes.
///
/// returns  the first part with a position that is not finite, or the number of parts
std::size_t pose_vertices(const Scene& scene, World& world, Tasks& tasks);

} // namespace firsthit
