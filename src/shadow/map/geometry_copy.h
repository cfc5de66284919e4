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
    std::size_t moved = 0;     // where they did first
    bool anyway = false;       // nobody needed to know last time
    bool is_old = false;       // not all was looked at
    std::uint64_t version = 0; // counts the changes
};

/// Counts a version where a byte differs from the last time, and brings the copy up to date. While
/// positions move from frame to frame, only those that moved are looked at, and while nobody needs to
/// know, nothing is: the first frame after that counts as changed too.
///
/// anyway  whatever depends on the geometry is made anew, changed or not
void follow(const World& world, bool anyway, GeometryCopy& copy, Tasks& tasks);

} // namespace firsthit
