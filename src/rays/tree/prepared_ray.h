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
        for (int axis = 0; axis < 3; ++axis) {
            direction[axis] = float(double(of.direction[axis]) * shrink);
            const bool negative = std::signbit(of.direction[axis]);
            near_row[axis] = negative ? 3 + axis : axis;
            far_row[axis] = negative ? axis : 3 + axis;
            slab_near[axis] = slab_far[axis] = origin[axis];
            float along = direction[axis];
            if (std::abs(along) < kLeast) [[unlikely]] {
                along = negative ? -kLeast : kLeast;
                widen_slab(axis, negative, largest_coordinate);
            }
            inverse[axis] = 1 / along;
        }
        has_range = of.t_min > 0 || of.t_max < std::numeric_limits<float>::infinity();
        if (has_range) limit_range(of);
    }

    static constexpr float kLeast = 0x1p-60f;

    const Ray* ray;
    double scale;        // scaled t of a t of 1
    glm::vec3 origin;    // of the ray
    glm::vec3 direction; // scaled
    // (plane - slab) * inverse is the scaled t of a box's plane.
    glm::vec3 slab_near, slab_far, inverse;
    int near_row[3], far_row[3]; // of TreeNode::bound
    bool has_range;              // t_min or t_max mean something
    // What is outside [first, last] is outside of t_min and t_max, what is inside the other two is inside.
    float first = 0, last = std::numeric_limits<float>::infinity();
    float first_inside = 0, last_inside = last;

  private:
    /// The slabs of an axis are met along a direction that differs by at most 2 kLeast, up to a scaled t of twice the
    /// largest coordinate. So they are made wider by as much as that moves the ray.
    [[gnu::noinline]] void widen_slab(int axis, bool negative, float largest_coordinate)
    {
        const double reach =
            double(largest_coordinate) +
            double(std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z)}));
        const double pad = 8 * double(kLeast) * reach, out = negative ? -pad : pad;
        const double near = double(origin[axis]) + out, far = double(origin[axis]) - out;
        slab_near[axis] = negative ? float_below(near) : float_above(near);
        slab_far[axis] = negative ? float_above(far) : float_below(far);
    }
    void limit_range(const Ray& of)
    {
        const double low = std::max(0.0, double(of.t_min) * scale), high = double(of.t_max) * scale;
        first = float_below(low);
        first_inside = float_above(low);
        last = float_above(high);
        last_inside = float_below(high);
    }
};

} // namespace firsthit
