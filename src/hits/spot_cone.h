// spot_cone.h - a spot's cone: how much light goes in a direction, for one direction at a time.
//
// It compiles the same text as spot_cone-inl.h (src/glsl/spot_cone.glsl), and so computes the same
// bits. Shadows and shading both use these functions, so that they agree on where a cone ends.
#pragma once

#include "base/scalar_real.h"

#include <firsthit/scene.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace firsthit {

namespace scalar {
#include "glsl/spot_cone.glsl"
} // namespace scalar

/// A spot's cone, in the numbers that the text takes. The versine of an angle is 1 - cos(angle).
struct SpotCone {
    glm::vec3 axis{0, -1, 0}; // unit vector in the direction of the light
    float outer = 1;          // versine of the half angle where the light ends
    float inv_width = 1;      // 1 / (outer - versine of the half angle where the light is full)
};

/// light  a spot that has passed the checks of scene/model/check_light.h
inline SpotCone spot_cone(const Light& light)
{
    const auto versine = [](double angle_rad) {
        const double sine = std::sin(angle_rad / 2);
        return 2 * sine * sine;
    };
    SpotCone cone;
    cone.axis = glm::vec3(glm::normalize(light.direction));
    cone.outer = static_cast<float>(versine(light.outer_rad));
    double width = versine(light.outer_rad) - versine(light.inner_rad);
    if (light.inverse_square) width = std::max(width, 0.001);  // KHR_lights_punctual
    const double steepest = std::numeric_limits<float>::max(); // a cone with a hard border
    cone.inv_width = static_cast<float>(width * steepest > 1 ? 1 / width : steepest);
    return cone;
}

/// The share of the spot's light that goes along d, from 0 to 1. It is 0 if d is 0, infinite or
/// NaN.
///
/// d  from the light to the point (to_light in exact/shadow_ray.h); of any length
inline float spot_share(const SpotCone& cone, const glm::vec3& d)
{
    const scalar::real3 axis(cone.axis.x, cone.axis.y, cone.axis.z);
    return scalar::cone_share(
        scalar::versine(axis, scalar::real3(d.x, d.y, d.z)), cone.outer, cone.inv_width);
}

/// Whether spot_share is above 0.
inline bool in_cone(const SpotCone& cone, const glm::vec3& d)
{
    const scalar::real3 axis(cone.axis.x, cone.axis.y, cone.axis.z);
    return scalar::versine(axis, scalar::real3(d.x, d.y, d.z)) < cone.outer;
}

} // namespace firsthit
