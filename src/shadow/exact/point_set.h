// point_set.h - points that are no pixels, in an order in which neighbours lie close together.
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"
#include "exact/shadow_ray.h"
#include "irregular/mesh/project_points_to_face.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

namespace firsthit {

/// World space, structure of arrays. Made once for all lights; what was given has to stay.
struct PointSet {
    std::span<const glm::vec3> given;
    std::span<const std::uint32_t> receivers; // the triangles that they lie on, or empty
    Buffer<float> x, y, z;                    // in the set's order
    Buffer<std::uint32_t> number;             // of each point among the given

    Buffer<std::uint64_t> key, spare; // while ordering
};

/// ordered    along a curve that fills the points' box, which costs about as much as testing them
///            against a light once, and makes each test several times faster where they were given
///            in no order
/// receivers  see firsthit/occlusion.h
/// source     Morton 1966 (the order of a z-curve)
void make_point_set(std::span<const glm::vec3> points, std::span<const std::uint32_t> receivers,
    bool ordered, PointSet& set, Tasks& tasks);

/// Points [first, first + chunk.count) as the light sees them; ids are the numbers of the given.
void move_points(
    const PointSet& set, const PencilSpace& space, std::size_t first, PointChunk& chunk);

} // namespace firsthit
