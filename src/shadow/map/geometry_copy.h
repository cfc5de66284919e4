// geometry_copy.h - finds out whether the geometry has changed since the last frame.
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"

#include <firsthit/scene.h>

#include <atomic>
#include <cstdint>

namespace firsthit {

/// A copy of a world's triangles to compare with. Comparing bytes is as fast as hashing them, and
/// certain. Takes 12 bytes for each vertex and 12 for each triangle.
struct GeometryCopy {
    Buffer<glm::vec3> position;
    Buffer<glm::uvec3> index;
    bool moving = false;       // positions differed in the last full comparison
    std::size_t moved = 0;     // start of the first range of positions that differed
    bool remade_all = false;   // remake_all of the last call
    bool is_stale = false;     // the copy may differ from the geometry of the last call
    std::uint64_t version = 0; // increases with each change
};

/// Increases copy.version if a byte of the geometry differs from the copy, and updates the copy.
/// Saves time in two cases, in which the copy becomes stale: while positions move from frame to
/// frame, only the range that moved first is compared; and while remake_all stays true, nothing is.
/// The first full comparison after that counts as a change.
///
/// remake_all  everything that depends on the geometry is made again in any case
void update_copy(const World& world, bool remake_all, GeometryCopy& copy, Tasks& tasks);

} // namespace firsthit
