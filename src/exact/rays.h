// rays.h - rays through one point as floats: where that of a sample is, in the world or in some other
// space.
#pragma once

#include "exact/pencil.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>

namespace firsthit {

/// The ray of sample (x, y) is at eye + t (right (X step_x) + down (Y step_y) + forward), X = x0 + x,
/// Y = y0 + y, at depth t. The first sample is that of a pencil's rectangle or of a tile. Shaders have the
/// same struct (gl/shaders/frame.glsl), with the same layout.
struct Rays {
    glm::vec3 eye{0};
    float step_x = 1; // in the world: 1 / Pencil::f
    glm::vec3 right{1, 0, 0};
    float step_y = 1;
    glm::vec3 down{0, 1, 0};
    float x0 = 0; // of the first sample; as y0, a multiple of 1/2, exact
    glm::vec3 forward{0, 0, 1};
    float y0 = 0;

    LatticeTile lattice() const { return {x0, y0}; }
};
static_assert(offsetof(Rays, right) == 16 && offsetof(Rays, x0) == 44 && sizeof(Rays) == 64);

/// The pencil's rays in world space; the first sample is that of `tile`.
Rays world_rays(const Pencil& pencil, const LatticeTile& tile);

/// Into the space matrix * (p - origin) + offset. All is put together in double, as texture projections
/// are, so that only small numbers are left for float. The result's steps are 1; its first sample is
/// that of `rays`, so that a sample's bits do not depend on the tile that it is in.
Rays transformed(
    const Rays& rays, const glm::dmat3& matrix, const glm::dvec3& origin, const glm::dvec3& offset);

} // namespace firsthit
