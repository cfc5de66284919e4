// prepared_ray.h - a ray as the traversal of a RayTree needs it.
//
// Traversal is in float. Its direction is scaled by a power of two so that the largest coordinate is in [1, 2):
// neither denormal nor huge directions overflow. Its depths are t times that power ("scaled t").
#pragma once

#include <firsthit/ray.h>

#include <glm/vec3.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace firsthit {

/// The largest float that is not above x, and the smallest that is not below.
inline float float_below(double x)
{
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    if (x > double(std::numeric_limits<float>::max()))
        return std::isinf(x) ? kInfinity : std::numeric_limits<float>::max();
    const float f = float(x);
    return double(f) > x ? std::nextafter(f, -kInfinity) : f;
}
inline float float_above(double x)
{
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    if (x > double(std::numeric_limits<float>::max())) return kInfinity;
    const float f = float(x);
    return double(f) < x ? std::nextafter(f, kInfinity) : f;
}

struct PreparedRay {
    /// The ray has to be usable (exact/ray_hit.h).
    PreparedRay(const Ray& of, float largest_coordinate) : ray(&of), origin(of.origin)
    {
        const glm::vec3 size = glm::abs(of.direction);
        // The exponent of the largest coordinate, which is a normal double, alone.
        constexpr std::uint64_t kExponent = 0x7FF0000000000000;
        scale = std::bit_cast<double>(
            std::bit_cast<std::uint64_t>(double(std::max({size.x, size.y, size.z}))) & kExponent);
        const double shrink = 1 / scale;
        const double reach =
            double(largest_coordinate) +
            double(std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z)}));
        for (int axis = 0; axis < 3; ++axis) {
            direction[axis] = float(double(of.direction[axis]) * shrink);
            const bool negative = std::signbit(of.direction[axis]);
            near_row[axis] = negative ? 3 + axis : axis;
            far_row[axis] = negative ? axis : 3 + axis;
            slab_near[axis] = slab_far[axis] = origin[axis];
            float along = direction[axis];
            if (std::abs(along) < kLeast) {
                // The slabs are met along a direction that differs by at most 2 kLeast, up to a scaled t of
                // 2 reach. So they are made wider by as much as that moves the ray.
                along = negative ? -kLeast : kLeast;
                const double pad = 8 * double(kLeast) * reach, out = negative ? -pad : pad;
                const double near = double(origin[axis]) + out, far = double(origin[axis]) - out;
                slab_near[axis] = negative ? float_below(near) : float_above(near);
                slab_far[axis] = negative ? float_above(far) : float_below(far);
            }
            inverse[axis] = 1 / along;
        }
        has_range = of.t_min > 0 || !std::isinf(of.t_max);
        first = float_below(std::max(0.0, double(of.t_min) * scale));
        last = float_above(double(of.t_max) * scale);
        first_inside = float_above(std::max(0.0, double(of.t_min) * scale));
        last_inside = float_below(double(of.t_max) * scale);
    }

    static constexpr float kLeast = 0x1p-60f;

    const Ray* ray;
    double scale;        // scaled t of a t of 1
    glm::vec3 origin;    // of the ray
    glm::vec3 direction; // scaled
    glm::vec3 slab_near, slab_far,
        inverse;                     // (plane - slab) * inverse is the scaled t of a box's plane
    int near_row[3], far_row[3];     // of TreeNode::bound
    bool has_range;                  // t_min or t_max mean something
    float first, last;               // what is outside these scaled t is outside of t_min and t_max
    float first_inside, last_inside; // what is between these is inside
};

} // namespace firsthit
