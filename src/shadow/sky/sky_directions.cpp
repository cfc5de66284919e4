// sky_directions.cpp - directions spread evenly over the upper hemisphere.
//
// source  González 2010, "Measurement of Areas on a Sphere Using Fibonacci and Latitude-Longitude
//         Lattices", Mathematical Geosciences 42(1)
#include "shadow/sky/sky_rays.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace firsthit {
namespace {

/// The unit vector along v; not finite if v is 0 or not finite. Scaled first, so that nothing overflows.
glm::dvec3 unit_along(const glm::dvec3& v)
{
    const glm::dvec3 scaled = v / std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return scaled / std::sqrt(glm::dot(scaled, scaled));
}

/// A unit vector perpendicular to the unit vector `up`.
glm::dvec3 perpendicular(const glm::dvec3& up)
{
    int least = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(up[axis]) < std::abs(up[least])) least = axis;
    glm::dvec3 helper(0);
    helper[least] = 1;
    return unit_along(glm::cross(helper, up));
}

} // namespace

glm::dvec3 zenith_of(const Sky& sky, const glm::dvec3& camera_up)
{
    const glm::dvec3& up = sky.up == glm::dvec3(0) ? camera_up : sky.up;
    const glm::dvec3 zenith = unit_along(up);
    if (std::isfinite(zenith.x + zenith.y + zenith.z)) return zenith;
    throw ArgumentError(fmt::format(
        "the sky's up ({}, {}, {}) is no direction: accepted is any finite vector but 0", up.x,
        up.y, up.z));
}

void check_sky_directions(int count)
{
    if (count < 0 || count > Sky::kMostDirections)
        throw ArgumentError(fmt::format(
            "{} directions of the sky is out of range: 0 to {}", count, Sky::kMostDirections));
}

void fill_sky_directions(int count, const glm::dvec3& zenith, std::vector<glm::dvec3>& directions)
{
    const glm::dvec3 side = perpendicular(zenith), other = glm::cross(zenith, side);
    // Turned step by step by the golden angle, pi (3 - sqrt 5): only sums and products, which have the
    // same bits on all machines. It starts off the axes, at a rational point of the circle.
    constexpr double kCosine = -0.7373688780783197, kSine = 0.6754902942615238;
    double c = 12.0 / 13, s = 5.0 / 13;
    directions.clear();
    for (int k = 0; k < count; ++k) {
        const double height = (k + 0.5) / count, across = std::sqrt(1 - height * height);
        directions.push_back(unit_along((side * c + other * s) * across + zenith * height));
        const double turned = c * kCosine - s * kSine;
        s = c * kSine + s * kCosine;
        c = turned;
    }
}

} // namespace firsthit
