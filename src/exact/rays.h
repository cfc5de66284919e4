// rays.h - rays through one point as floats: where that of a sample is, in the world or in some other
// space.
#pragma once

#include "exact/pencil.h"

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>

namespace firsthit {

/// The ray of sample (x, y) is at eye + t (right (X step_x) + down (Y step_y) + forward), X = x0 + x,
/// Y = y0 + y, at depth t. Parallel rays are at (eye + right (X step_x) + down (Y step_y)) + t forward. The
/// first sample is that of a pencil's rectangle or of a tile. Shaders have the same
/// struct (gl/rays_layout.glsl), with the same layout; they are given no parallel rays.
struct alignas(16) Rays {
    glm::vec3 eye{0};
    float step_x = 1; // in the world: 1 / Pencil::f
    glm::vec3 right{1, 0, 0};
    float step_y = 1;
    glm::vec3 down{0, 1, 0};
    float x0 = 0; // of the first sample; as y0, a multiple of 1/2, exact
    glm::vec3 forward{0, 0, 1};
    float y0 = 0;
    std::int32_t parallel = 0; // 1: the rays are parallel

    /// The point at depth t of a ray, for X and Y, not rounded to float.
    glm::dvec3 point(double x, double y, double t) const
    {
        const glm::dvec3 across =
            glm::dvec3(right) * (x * double(step_x)) + glm::dvec3(down) * (y * double(step_y));
        return glm::dvec3(eye) + (parallel ? across : t * across) + t * glm::dvec3(forward);
    }

    /// The sums of the sizes of what point() adds, axis by axis: bounds of its rounding errors in float are
    /// proportional to them.
    glm::dvec3 point_size(double x, double y, double t) const
    {
        const glm::dvec3 across = glm::abs(glm::dvec3(right) * (x * double(step_x))) +
                                  glm::abs(glm::dvec3(down) * (y * double(step_y)));
        return glm::abs(glm::dvec3(eye)) + (parallel ? across : t * across) +
               t * glm::abs(glm::dvec3(forward));
    }

    LatticeTile lattice() const { return {x0, y0}; }
};
static_assert(offsetof(Rays, right) == 16 && offsetof(Rays, x0) == 44 && sizeof(Rays) == 80);

/// The pencil's rays in world space; the first sample is that of `tile`.
Rays world_rays(const Pencil& pencil, const LatticeTile& tile);

/// Into the space matrix * (p - origin) + offset. All is put together in double, as texture projections
/// are, so that only small numbers are left for float. The result's steps are 1; its first sample is
/// that of `rays`, so that a sample's bits do not depend on the tile that it is in.
Rays transformed(
    const Rays& rays, const glm::dmat3& matrix, const glm::dvec3& origin, const glm::dvec3& offset);

} // namespace firsthit
