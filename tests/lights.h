// lights.h - lights from a few words, for tests.
#pragma once

#include <firsthit/scene.h>

namespace firsthit::test {

inline Light point_light(const glm::dvec3& position)
{
    Light light;
    light.position = position;
    return light;
}

inline Light directional_light(const glm::dvec3& direction)
{
    Light light;
    light.kind = Light::Kind::directional;
    light.direction = direction;
    return light;
}

/// inner_share  of the outer angle
inline Light spot_light(const glm::dvec3& position, const glm::dvec3& direction, double outer_rad,
    double inner_share = 0)
{
    Light light;
    light.kind = Light::Kind::spot;
    light.position = position;
    light.direction = direction;
    light.inner_rad = inner_share * outer_rad;
    light.outer_rad = outer_rad;
    return light;
}

} // namespace firsthit::test
