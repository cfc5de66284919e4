// spot_cone.h - a spot's cone: which directions have light, one at a time.
//
// The text (src/glsl/spot_cone.glsl) and so the bits are those of spot_cone-inl.h, which takes a
// register of directions. Shadows and shading ask here, so that they agree where a cone ends.
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

/// The numbers that the text asks for.
struct SpotCone {
    glm::vec3 axis{0, -1, 0}; // unit: the way the light goes
    float outer = 1;          // versine of the half angle where the light ends
    float inv_width = 1;      // one over its difference to that of the half angle of full light
};

/// light  a spot that is sound (scene/model/check_light.h)
inline SpotCone spot_cone(const Light& light)
{
    const auto versine = [](double angle_rad) {
        const double sine = std::sin(angle_rad / 2);
        return 2 * sine * sine;
    };
    SpotCone cone;
    cone.axis = glm::vec3(glm::normalize(light.direction));
    cone.outer = static_cast<float>(versine(light.outer_rad));
    const double width = versine(light.outer_rad) - versine(light.inner_rad);
    const double steepest = std::numeric_limits<float>::max(); // a cone with a hard border
    cone.inv_width = static_cast<float>(width * steepest > 1 ? 1 / width : steepest);
    return cone;
}

/// How much of the spot's light goes along d, 0 to 1; d goes from the light to the point (to_light
/// in exact/shadow_ray.h). 0 where d is 0, infinite or no number.
inline float spot_share(const SpotCone& cone, const glm::vec3& d)
{
    const scalar::real3 axis(cone.axis.x, cone.axis.y, cone.axis.z);
    return scalar::cone_share(
        scalar::versine(axis, scalar::real3(d.x, d.y, d.z)), cone.outer, cone.inv_width);
}

/// Whether that is above 0.
inline bool in_cone(const SpotCone& cone, const glm::vec3& d)
{
    const scalar::real3 axis(cone.axis.x, cone.axis.y, cone.axis.z);
    return scalar::versine(axis, scalar::real3(d.x, d.y, d.z)) < cone.outer;
}

} // namespace firsthit
