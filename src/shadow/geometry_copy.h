// geometry_copy.h - has the geometry changed since it was last looked at?
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"

#include <firsthit/scene.h>

#include <atomic>
#include <cstdint>

namespace firsthit {

/// A copy of a world's triangles: comparing bytes is as fast as a hash, and certain. 12 bytes a
/// vertex and a triangle.
struct GeometryCopy {
    Buffer<glm::vec3> position;
    Buffer<glm::uvec3> index;
    bool moving = false;       // positions differed last time
    bool index_is_old = false; // and the index was not looked at
    std::uint64_t version = 0; // counts the changes
};

/// Brings the copy up to date; counts a version where a byte differed. While positions move from
/// frame to frame, nobody asks whether the index did, which would read as much again: the first frame that
/// stands still after them counts as changed too.
void follow(const World& world, GeometryCopy& copy, Tasks& tasks);

} // namespace firsthit
