// item_plane.h - the planes of triangles as the rays of a picture meet them, not exact.
#pragma once

#include "exact/hit.h"
#include "exact/pencil.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace firsthit {

/// From the normals of eye space to those of the world.
struct NormalTransform {
    glm::mat3 matrix{1}; // the transposed Pencil::eye_from_world
    /// Parallel rays: s = scale / (far - z) makes of the plane a x + b y + c z + e = 0 the plane
    /// a X + b Y + (c far + e) Z = c scale, whose coefficients over c scale are an ItemPlane. So its normal
    /// (a, b, c) is as (x, y, 1 / scale).
    bool parallel = false;
    float along = 0;

    explicit NormalTransform(const Pencil& pencil)
        : matrix(glm::transpose(pencil.eye_from_world)),
          parallel(pencil.parallel),
          along(float(1 / pencil.scale))
    {
    }
};

/// The plane of a triangle in eye space: 1/t = x X + y Y + z for the ray of direction (X, Y, 1). Not
/// finite if the eye is in the plane.
struct ItemPlane {
    float x, y, z;

    explicit ItemPlane(const Corners& corners)
    {
        const glm::dvec3 a(corners[0]), b(corners[1]), c(corners[2]);
        const glm::dvec3 n = glm::cross(b - a, c - a);
        const double inverse = 1 / glm::dot(n, a);
        x = float(n.x * inverse), y = float(n.y * inverse), z = float(n.z * inverse);
    }

    float inverse_depth(const glm::vec2& d) const { return x * d.x + y * d.y + z; }

    /// How far 1/t changes from a pixel's centre to the farthest point of its square.
    float reach() const { return 0.5f * (std::abs(x) + std::abs(y)); }

    /// A normal in the world, away from the eye, of any length.
    glm::vec3 normal(const NormalTransform& to_world) const
    {
        return to_world.matrix * glm::vec3(x, y, to_world.parallel ? to_world.along : z);
    }
};

/// Whether two normals are at most 30 degrees apart.
inline bool are_close(const glm::vec3& n, const glm::vec3& m)
{
    constexpr float kCos2 = 0.75f; // the cosine's square
    const float along = glm::dot(n, m);
    return along > 0 && along * along >= kCos2 * glm::dot(n, n) * glm::dot(m, m);
}

/// Depths that differ by less, relatively, are those of one surface.
inline constexpr float kSameDepth = 1e-4f;

} // namespace firsthit
