// shadow_ray.h - exact predicate: whether a triangle shadows a point from a light. These functions
// are the definition of exact shadows. The irregular z-buffer and the oracles call them, or a
// filter that is proven to agree with them.
//
// Points and vertices are moved into the light's space and rounded to float once; these floats are
// then taken as exact. A point light is at the origin, and the shadow ray of a point d is the ray
// along d (exact/hit.h). A directional light shines along z, and the shadow ray of d comes from
// z = -infinity through (d.x, d.y). Whether it hits a triangle is decided by the same predicates,
// with the z of the ray and of all corners replaced by 1.
//
// A lamp that is far away from all vertices and points is seen as a directional light too, as its rays are
// nearly parallel: positions relative to it would lose the scene's own size in rounding. With the lamp at
// (0, 0, -D) and its light along z, (x, y, z) becomes k (x, y, z), k = D / (D + z). This projective map makes
// the lamp's rays parallel to z; planes stay planes, and order along a ray stays.
//
//   shadowed  iff the ray hits, and d lies behind the triangle's plane by more than both margins:
//             facing * N . (d - v0) > (shadow_margin(d) + corner_margin) * (|N.x| + |N.y| + |N.z|)
//
// The margins cover the rounding errors of d and of the corners (see kShadowMargin), and contain
// nothing else. Without them a point would sometimes be shadowed by a neighbour of the triangle
// that it lies on, or by a triangle in the same plane. The corner margin depends on the farthest
// corner, because a large triangle's plane is off by as much everywhere, also near the light.
// Margins are distances from the plane, not along the ray, so they need not grow for grazing light.
//
// A point that is known to lie on a triangle (its receiver) is first moved off the triangle's plane
// towards the light, by half the margins (see lifted). Rounding may have put the point behind the
// plane; there a grazing ray would enter the surface through the next triangle, and if that is
// steeper, far above the point.
//        light .                      ____ the surface
//                 '  .  ___....---'''
//                  ___':-  -  -  -  -  x     a point too low, and its ray
//                 /
//
// All answers are those of exact real arithmetic on the floats.
#pragma once

#include "exact/hit.h"

#include <firsthit/scene.h>

#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace firsthit {

/// Margins relative to the size of the rounded numbers: 8 u, where u = 2^-24 is the largest
/// relative error of one rounding to float.
///
/// The answers are exact for any margin, because it is part of the definition of a shadow. Its size
/// decides only whether rounding can let a surface shadow itself, so compare it with the errors. A
/// hit is computed as p = eye + t D with D = X right + Y down + forward (hits/hit_position.h). |.|
/// is the largest coordinate, and r the length of p - eye. The errors of a coordinate are at most
///     u (|eye| + |p| + |d|)  for rounding the eye, the last sum, and d in the light's space
///     5 u r                  for the three terms of D: 4 roundings in each of the first two and in
///                            their sum 1, and 1 in the third (by Cauchy and Schwarz, because the
///                            factors of the terms are a row of a rotation)
///     4 u |p - eye|          for the sum D (1), t (2, one unit in the last place), and t D (1)
/// and the plane that the hit lies on has errors of at most u times its corners' coordinates, once
/// in eye space and once in the light's space.
///
/// If all of these had their largest value and the same sign, they would be up to 1.7 times the
/// margin of the point for a point light (eye and light opposite each other around the origin, the
/// point near the light, at a corner of the picture), and 2 times for a directional light, whose
/// rotation can add the errors of three coordinates. So the margin is not a proven bound. In
/// practice it is not reached: the largest error in 8 * 10^7 random hits, half of them near the
/// worst case, was 0.76 of the margin (tests/render/shadow_margin_test.cpp repeats this with fewer
/// hits). Because of the lift, a triangle in the receiver's plane is even 1.5 margins away.
inline constexpr float kShadowMargin = 0x1p-21f;

/// Margins are computed in float. The sum of a point's and a triangle's margin is within two
/// roundings plus this absolute error of the exact sum.
inline constexpr double kMarginUnderflow = 0x1p-149;

/// The space of a light: its position or direction. See to_light.
struct PencilSpace {
    bool directional = false;
    glm::vec3 origin{0}; // point, spot: where the light is
    glm::dmat3 axes{1};  // directional: orthonormal; the third row is the direction of the light
    float reach = 0; // largest coordinates of light and eye, which points were rounded relative to
    double distance = 0; // D of a lamp that is seen as directional; else 0
    glm::vec3 lamp{0};   // where that lamp is

    /// Moves a point into the space of a directional light or a far lamp. Not rounded to float.
    glm::dvec3 turned(const glm::dvec3& p) const
    {
        const auto row = [&](int r) {
            return (axes[0][r] * p.x + axes[1][r] * p.y) + axes[2][r] * p.z;
        };
        const glm::dvec3 q(row(0), row(1), row(2));
        return distance > 0 ? q * (distance / (distance + q.z)) : q;
    }
};

/// A lamp that is so many times as far from the world's origin as any vertex or point is seen as directional.
inline constexpr double kFarLamp = 64;

/// eye       position from which the points were computed: their rounding errors depend on it
/// farthest  the largest coordinate of all vertices and points; infinite: no lamp is far
PencilSpace light_space(const Light& light, const glm::dvec3& eye,
    float farthest = std::numeric_limits<float>::infinity());

/// Whether a lamp is far from what has no larger coordinate than `farthest`.
bool is_far_lamp(const Light& light, float farthest);

/// Moves a point or vertex into the light's space, with a single rounding.
inline glm::vec3 to_light(const PencilSpace& space, const glm::vec3& p)
{
    return space.directional ? glm::vec3(space.turned(glm::dvec3(p))) : p - space.origin;
}

/// From a lamp to a point: what cones of spots are asked for.
///
/// d  to_light of p
inline glm::vec3 from_lamp(const PencilSpace& space, const glm::vec3& p, const glm::vec3& d)
{
    return space.distance > 0 ? p - space.lamp : d;
}

inline float largest_coordinate(const glm::vec3& d)
{
    return std::max(std::max(std::abs(d.x), std::abs(d.y)), std::abs(d.z));
}

/// The margin of a point for its rounding errors, as a distance in the light's space.
inline float shadow_margin(const PencilSpace& space, const glm::vec3& d)
{
    return kShadowMargin * (2 * largest_coordinate(d) + space.reach);
}

/// The margin of a triangle for the rounding errors of its corners, which are given in the light's
/// space. Moving them there rounds each coordinate once, so this is 8 times the largest error of
/// that.
inline float corner_margin(const Corners& c)
{
    return kShadowMargin * std::max(std::max(largest_coordinate(c[0]), largest_coordinate(c[1])),
                               largest_coordinate(c[2]));
}

/// What is needed to lift points off the triangle that they lie on.
struct Receiver {
    glm::vec3 away{0}; // normal towards the light; its largest coordinate is 1, or all are 0
    float margin = 0;  // corner_margin
};

/// side  light_side of the corners; the receiver of side 0 does not move points
Receiver receiver_of(const Corners& c, int side);

/// Moves the point d of the receiver off its plane, towards the light.
inline glm::vec3 lifted(const PencilSpace& space, const glm::vec3& d, const Receiver& receiver)
{
    const float height = 0.5f * (shadow_margin(space, d) + receiver.margin);
    return d + receiver.away * height;
}

/// Whether a point has a shadow ray: it is finite, and not at the light's position. A point without
/// one is never in shadow.
inline bool has_shadow_ray(const PencilSpace& space, const glm::vec3& d)
{
    return usable(d) && (space.directional || d != glm::vec3(0));
}

/// The corners of a triangle that a ray from the origin hits if and only if the light's ray hits c.
inline Corners pencil_corners(const PencilSpace& space, const Corners& c)
{
    if (!space.directional) return c;
    return {
        glm::vec3(c[0].x, c[0].y, 1), glm::vec3(c[1].x, c[1].y, 1), glm::vec3(c[2].x, c[2].y, 1)};
}

/// The same for the weights of the corners, which are those of the world. A far lamp's space has weights of
/// its own: so its corners are (x, y, z) / k there, with 1 + z / D = 1 / k in the place of z. Rounded once.
Corners weight_corners(const PencilSpace& space, const Corners& c);

/// The direction of the light's ray through d that goes with pencil_corners and weight_corners.
inline glm::vec3 pencil_ray(const PencilSpace& space, const glm::vec3& d)
{
    return space.directional ? glm::vec3(d.x, d.y, 1) : d;
}

/// Whether the triangle shadows the point d. All in the light's space.
bool is_shadowed(const PencilSpace& space, const Corners& c, const glm::vec3& d, Effort& effort);

/// The side of the triangle's plane that the light is on, exactly: 1 if the corners are clockwise
/// as seen from the light (as volume_sign), -1 if not, 0 if the light lies in the plane or the
/// corners are not usable.
int light_side(const PencilSpace& space, const Corners& c, Effort& effort);

} // namespace firsthit
