// hit_position.h - the point in world space that a sample sees, one at a time.
//
// The text (src/glsl/hit_position.glsl) and so the bits are those of hit_position-inl.h, which
// takes a register of samples: who reasons about such a point exactly may use either.
#pragma once

#include "base/scalar_real.h"
#include "exact/rays.h"

namespace firsthit {

namespace scalar {
#include "glsl/hit_position.glsl"

FIRSTHIT_PURE real3 from_glm(const glm::vec3& v)
{
    return real3(v.x, v.y, v.z);
}

/// The direction of sample (x, y) of the tile, whole numbers from 0.
FIRSTHIT_PURE real3 ray_direction(const Rays& rays, real x, real y)
{
    return ray_direction(rays.x0 + x, rays.y0 + y, rays.step_x, rays.step_y, from_glm(rays.right),
        from_glm(rays.down), from_glm(rays.forward));
}
} // namespace scalar

/// The point that sample (x, y) of the tile sees at depth t.
inline glm::vec3 hit_position(const Rays& rays, float x, float y, float t)
{
    const scalar::real3 p =
        scalar::hit_position(scalar::from_glm(rays.eye), scalar::ray_direction(rays, x, y), t);
    return {p.x, p.y, p.z};
}

} // namespace firsthit
