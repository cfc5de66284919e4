// cube_face.h - one side of the cube around a light, or all that a directional light shines on.
#pragma once

#include "exact/shadow_ray.h"

#include <glm/vec3.hpp>

#include <cmath>

namespace firsthit {

inline constexpr int kLightFaces = 6;

/// How far x and y of samples may be from 0: of the wide face. Others' are within 1.
inline constexpr float kWidestFace = 8;

/// Coordinates on one face: d in the light's space is seen at (x, y) = (a, b) / c, where c is the
/// coordinate along the face's axis and a, b are the other two; they only change places and sign,
/// so nothing is rounded. The depth is kept as w = 1 / c. A directional light has one face, where
/// (x, y) = (a, b) and w = -c. In both, w is affine in (x, y) on a plane, and greater is nearer to
/// the light.
struct CubeFace {
    bool directional = false;
    int axis_a = 0, axis_b = 1, axis_c = 2;
    float sign = 1; // of the axis

    glm::vec3 seen_from(const glm::vec3& d) const
    {
        return {d[axis_a], d[axis_b], sign * d[axis_c]};
    }
};

/// number  0 to 5: +x, -x, +y, -y, +z, -z; a directional light has number 0 only
inline CubeFace cube_face(bool directional, int number)
{
    if (directional) return {.directional = true};
    const int axis = number / 2;
    return {.axis_a = (axis + 1) % 3,
        .axis_b = (axis + 2) % 3,
        .axis_c = axis,
        .sign = number % 2 ? -1.0f : 1.0f};
}

/// A point as its face sees it: one rounding each, so what lies between two points is seen between
/// them. x and y of a point light's samples are within kWidestFace.
struct ProjectedPoint {
    float x, y, w;
};

} // namespace firsthit
