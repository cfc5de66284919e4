// light_face.h - one side of the cube around a light, or all that a directional light shines on.
#pragma once

#include "exact/shadow_ray.h"

#include <glm/vec3.hpp>

#include <cmath>

namespace firsthit {

inline constexpr int kLightFaces = 6;

/// Coordinates on one face: d in the light's space is seen at (x, y) = (a, b) / c, where c is the
/// coordinate along the face's axis and a, b are the other two; they only change places and sign,
/// so nothing is rounded. The depth is kept as w = 1 / c. A directional light has one face, where
/// (x, y) = (a, b) and w = -c. In both, w is affine in (x, y) on a plane, and greater is nearer to
/// the light.
struct LightFace {
    bool directional = false;
    int axis_a = 0, axis_b = 1, axis_c = 2;
    float sign = 1; // of the axis

    glm::vec3 seen_from(const glm::vec3& d) const
    {
        return {d[axis_a], d[axis_b], sign * d[axis_c]};
    }
};

/// number  0 to 5: +x, -x, +y, -y, +z, -z; a directional light has number 0 only
inline LightFace light_face(bool directional, int number)
{
    if (directional) return {.directional = true};
    const int axis = number / 2;
    return {.axis_a = (axis + 1) % 3,
        .axis_b = (axis + 2) % 3,
        .axis_c = axis,
        .sign = number % 2 ? -1.0f : 1.0f};
}

/// A point as its face sees it. x and y are within 1 for a point light.
struct SeenPoint {
    float x, y, w;
};

/// One rounding each, so the order of points is kept: what lies between two points is seen between
/// them.
inline SeenPoint see(const LightFace& face, const glm::vec3& d)
{
    const glm::vec3 p = face.seen_from(d);
    if (face.directional) return {p.x, p.y, -p.z};
    return {p.x / p.z, p.y / p.z, 1.0f / p.z};
}

} // namespace firsthit
