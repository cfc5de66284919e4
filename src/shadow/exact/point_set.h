// point_set.h - arbitrary points to test for shadows, sorted so that neighbours are near in memory.
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"
#include "exact/shadow_ray.h"
#include "irregular/mesh/project_points_to_face.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

namespace firsthit {

/// Points in world space, as a structure of arrays. Made once and used for all lights. Keeps views
/// of the caller's arrays, which must outlive it.
struct PointSet {
    std::span<const glm::vec3> given;
    std::span<const std::uint32_t> receivers; // the triangle that each lies on; may be empty
    Buffer<float> x, y, z;                    // in sorted order
    Buffer<std::uint32_t> number;             // index of each sorted point in `given`

    Buffer<std::uint64_t> key, spare; // scratch memory of sorting
};

/// Copies the points, sorted if `ordered`.
/// ordered    sort along a space-filling curve. Costs about as much as testing the points against
///            one light, and makes each test several times faster for points in random order
/// receivers  see firsthit/occlusion.h
/// source     Morton 1966, "A Computer Oriented Geodetic Data Base" (z-order curve)
void make_point_set(std::span<const glm::vec3> points, std::span<const std::uint32_t> receivers,
    bool ordered, PointSet& set, Tasks& tasks);

/// Moves the sorted points [first, first + chunk.count) into the light's space. Their ids are their
/// indices in `given`.
void move_points(
    const PointSet& set, const PencilSpace& space, std::size_t first, PointChunk& chunk);

} // namespace firsthit
