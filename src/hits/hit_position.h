// hit_position.h - the point in world space that a sample sees, one at a time.
//
// The text (src/glsl/hit_position.glsl) and so the bits are those of hit_position-inl.h, which
// takes a register of samples: who reasons about such a point exactly may use either.
#pragma once

#include "base/scalar_real.h"
#include "hits/hit_tile.h"

namespace firsthit {

namespace scalar {
#include "glsl/hit_position.glsl"

FIRSTHIT_PURE real3 from_glm(const glm::vec3& v)
{
    return real3(v.x, v.y, v.z);
}

/// The direction of sample (x, y) of the tile, whole numbers from 0.
FIRSTHIT_PURE real3 ray_direction(const TileFrame& frame, real x, real y)
{
    return ray_direction(frame.x0 + x, frame.y0 + y, frame.inv_f, from_glm(frame.world_from_eye[0]),
        from_glm(frame.world_from_eye[1]), from_glm(frame.world_from_eye[2]));
}
} // namespace scalar

/// The point that sample (x, y) of the tile sees at depth t.
inline glm::vec3 hit_position(const TileFrame& frame, float x, float y, float t)
{
    const scalar::real3 p =
        scalar::hit_position(scalar::from_glm(frame.eye), scalar::ray_direction(frame, x, y), t);
    return {p.x, p.y, p.z};
}

} // namespace firsthit
