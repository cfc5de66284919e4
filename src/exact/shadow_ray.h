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
//   shadowed  iff the ray hits, and d lies behind the triangle's plane by more than both margins:
//             facing * N . (d - v0) > (shadow_margin(d) + corner_margin) * (|N.x| + |N.y| + |N.z|)
//
// The margins are as large as the roundings on the way to d and to the corners, and nothing else:
// without them a point would now and then be shadowed by a neighbour of the triangle that it lies
// on, or by one in the same plane. The plane of a large triangle is off by as much as its farthest
// corner, also near the light. Margins are distances from the plane, not along the ray, so grazing
// light needs no more of them.
//
// A point that is known to lie on a triangle is first moved off its plane, towards the light, by
// half its margins (lifted): roundings may have put it behind, where a ray that grazes the triangle
// would enter the surface through the next one, far above the point if that is steeper.
//
//        light .                      ____ the surface
//                 '  .  ___....---'''
//                  ___':-  -  -  -  -  x     a point too low, and its ray
//                 /
//
// Everything is what real arithmetic says of the floats.
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

/// Margins are floats: of a point and of corners together they are within two roundings, and
/// this, of what real arithmetic says.
inline constexpr double kMarginUnderflow = 0x1p-149;

/// A light's frame.
struct PencilSpace {
    bool directional = false;
    glm::vec3 origin{0}; // point, spot: where the light is
    glm::dmat3 axes{1};  // directional: rows: across, across, the way the light goes; orthonormal
    float reach = 0; // what else was rounded on the way: the largest coordinates of light and eye
};

/// eye  where the points were seen from: their roundings are relative to it too
PencilSpace light_space(const Light& light, const glm::dvec3& eye);

/// A point or vertex as the light sees it, rounded once.
inline glm::vec3 to_light(const PencilSpace& space, const glm::vec3& p)
{
    if (!space.directional) return p - space.origin;
    const auto row = [&](int r) {
        return float((space.axes[0][r] * double(p.x) + space.axes[1][r] * double(p.y)) +
                     space.axes[2][r] * double(p.z));
    };
    return {row(0), row(1), row(2)};
}

inline float largest_coordinate(const glm::vec3& d)
{
    return std::max(std::max(std::abs(d.x), std::abs(d.y)), std::abs(d.z));
}

/// How far behind a plane the point has to lie because of its own roundings. In units of the
/// light's space.
inline float shadow_margin(const PencilSpace& space, const glm::vec3& d)
{
    return kShadowMargin * (2 * largest_coordinate(d) + space.reach);
}

/// How much farther because of the triangle's: its corners in the light's space.
inline float corner_margin(const Corners& c)
{
    return kShadowMargin * std::max(std::max(largest_coordinate(c[0]), largest_coordinate(c[1])),
                               largest_coordinate(c[2]));
}

/// A triangle as the place of points.
struct Receiver {
    glm::vec3 away{0}; // from its plane to the light's side; largest coordinate 1, or all 0
    float margin = 0;  // corner_margin
};

/// side  light_side of the corners; 0 lifts nothing
Receiver receiver_of(const Corners& c, int side);

/// The point d of the triangle, moved off its plane.
inline glm::vec3 lifted(const PencilSpace& space, const glm::vec3& d, const Receiver& receiver)
{
    const float height = 0.5f * (shadow_margin(space, d) + receiver.margin);
    return d + receiver.away * height;
}

/// Whether a point can be shadowed at all: finite, and not where the light is.
inline bool has_shadow_ray(const PencilSpace& space, const glm::vec3& d)
{
    return usable(d) && (space.directional || d != glm::vec3(0));
}

/// Whether the triangle (corners in the light's space) shadows the point d.
bool is_shadowed(const PencilSpace& space, const Corners& c, const glm::vec3& d, Effort& effort);

/// On which side of the triangle's plane the light is: exact, 0 where it lies in it. 1 where the
/// light sees the corners clockwise in a right-handed frame, as volume_sign.
int light_side(const PencilSpace& space, const Corners& c, Effort& effort);

} // namespace firsthit
