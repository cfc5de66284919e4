// hit_position.h - computes the point in world space that a sample sees, for one sample at a time.
//
// It compiles the same text as hit_position-inl.h (src/glsl/hit_position.glsl), which takes a
// register of samples, and so computes the same bits. Code that reasons exactly about such a point
// may use either.
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

/// The offset and the direction of sample (x, y) of the tile, in world space. x and y are whole numbers
/// from 0.
FIRSTHIT_PURE real3 ray_offset(const Rays& rays, real x, real y)
{
    return ray_offset(rays.x0 + x, rays.y0 + y, rays.step_x, rays.step_y, from_glm(rays.right),
        from_glm(rays.down));
}
FIRSTHIT_PURE real3 ray_direction(const Rays& rays, real x, real y)
{
    return ray_direction(rays.x0 + x, rays.y0 + y, rays.step_x, rays.step_y, from_glm(rays.right),
        from_glm(rays.down), from_glm(rays.forward));
}
} // namespace scalar

/// The point in world space that sample (x, y) of the tile sees at depth t.
inline glm::vec3 hit_position(const Rays& rays, float x, float y, float t)
{
    const scalar::real3 eye = scalar::from_glm(rays.eye), forward = scalar::from_glm(rays.forward);
    const scalar::real3 p =
        rays.parallel ? scalar::hit_position(eye + scalar::ray_offset(rays, x, y), forward, t)
                      : scalar::hit_position(eye, scalar::ray_direction(rays, x, y), t);
    return {p.x, p.y, p.z};
}

} // namespace firsthit
