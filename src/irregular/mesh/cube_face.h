// cube_face.h - one face of the cube around a pencil's origin, or the image plane of a parallel
// pencil.
//
// A pencil is a set of rays that all go through one point (its origin: a point light or an eye), or
// that are all parallel (a directional light).
#pragma once

#include "exact/shadow_ray.h"

#include <glm/vec3.hpp>

#include <cmath>

namespace firsthit {

inline constexpr int kCubeFaces = 6;

/// The limit of |x| and |y| of samples on a wide face (PencilMesh::wide_face). On the six ordinary
/// faces |x| and |y| are at most 1.
inline constexpr float kWideFaceLimit = 8;

/// The projection to one face. A point of the pencil's space has the coordinates (a, b, c) in the
/// axes of the face: c is the one along the face's normal. These are the point's own coordinates,
/// reordered and c with a sign, so they are not rounded.
///
///     pencil with an origin   (x, y) = (a, b) / c   w = 1 / c     six faces; the face has c > 0
///     parallel pencil         (x, y) = (a, b)       w = -c        one face
///
/// In both, w is an affine function of (x, y) on a plane, and a greater w is nearer to the origin.
struct CubeFace {
    bool directional = false;
    int axis_a = 0, axis_b = 1, axis_c = 2;
    float sign = 1; // c = sign * d[axis_c]

    /// (a, b, c) of a point in the pencil's space.
    glm::vec3 to_face_axes(const glm::vec3& d) const
    {
        return {d[axis_a], d[axis_b], sign * d[axis_c]};
    }
};

/// number  0 to 5: +x, -x, +y, -y, +z, -z. Ignored for a parallel pencil, which has one face
inline CubeFace cube_face(bool directional, int number)
{
    if (directional) return {.directional = true};
    const int axis = number / 2;
    return {.axis_a = (axis + 1) % 3,
        .axis_b = (axis + 2) % 3,
        .axis_c = axis,
        .sign = number % 2 ? -1.0f : 1.0f};
}

/// A point projected to a face. Each coordinate is rounded once, so the projection is monotonic: a
/// coordinate that lies between two others in real arithmetic does so after rounding.
struct ProjectedPoint {
    float x, y, w;
};

} // namespace firsthit
