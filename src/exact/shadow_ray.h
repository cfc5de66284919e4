// shadow_ray.h - does a triangle stand between a light and a point? The one place where that is
// decided: the irregular z-buffer and the oracles call these functions, or a filter that is proven
// to agree with them.
//
// Points and vertices are moved into the light's space once and rounded to float; these floats are
// then exact. A point light stands at the origin, and the shadow ray of a point d is the ray along
// d (exact/hit.h). A directional light shines along z, and the shadow ray of d comes from z =
// -infinity through (d.x, d.y): the same predicates with 1 in the place of z say which triangles it
// hits.
//
//   shadowed  iff the ray hits, and d lies behind the triangle's plane by more than its margin:
//             facing * N . (d - v0) > margin * (|N.x| + |N.y| + |N.z|)
//
// The margin is as large as the roundings on the way to d, and nothing else: without it a point
// would now and then be shadowed by a neighbour of the triangle that it lies on, or by one in the
// same plane. It is a distance from the plane, not along the ray, so grazing light needs no more of
// it. Everything is what real arithmetic says of the floats.
#pragma once

#include "exact/hit.h"

#include <firsthit/scene.h>

#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>

namespace firsthit {

/// Of the size of the numbers that were rounded: four roundings of a point and two of its way to
/// the light, twice.
inline constexpr float kShadowMargin = 0x1p-21f;

/// A light's frame.
struct LightSpace {
    bool directional = false;
    glm::vec3 origin{0}; // point, spot: where the light is
    glm::dmat3 axes{1};  // directional: rows: across, across, the way the light goes; orthonormal
    float reach = 0; // what else was rounded on the way: the largest coordinates of light and eye
};

/// eye  where the points were seen from: their roundings are relative to it too
LightSpace light_space(const Light& light, const glm::dvec3& eye);

/// A point or vertex as the light sees it, rounded once.
inline glm::vec3 to_light(const LightSpace& space, const glm::vec3& p)
{
    if (!space.directional) return p - space.origin;
    const auto row = [&](int r) {
        return float((space.axes[0][r] * double(p.x) + space.axes[1][r] * double(p.y)) +
                     space.axes[2][r] * double(p.z));
    };
    return {row(0), row(1), row(2)};
}

/// How far behind a plane the point has to lie. In units of the light's space.
inline float shadow_margin(const LightSpace& space, const glm::vec3& d)
{
    const float largest = std::max(std::max(std::abs(d.x), std::abs(d.y)), std::abs(d.z));
    return kShadowMargin * (2 * largest + space.reach);
}

/// Whether a point can be shadowed at all: finite, and not where the light is.
inline bool has_shadow_ray(const LightSpace& space, const glm::vec3& d)
{
    return usable(d) && (space.directional || d != glm::vec3(0));
}

/// Whether the triangle (corners in the light's space) shadows the point d.
bool is_shadowed(const LightSpace& space, const Corners& c, const glm::vec3& d, Effort& effort);

/// On which side of the triangle's plane the light is: exact, 0 where it lies in it. 1 where the
/// light sees the corners clockwise in a right-handed frame, as volume_sign.
int light_side(const LightSpace& space, const Corners& c, Effort& effort);

} // namespace firsthit
