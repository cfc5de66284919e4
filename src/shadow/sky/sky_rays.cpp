// sky_rays.cpp - a sky in the form that shading needs.
#include "shadow/sky/sky_rays.h"

namespace firsthit {

void set_up_sky(
    const Sky& sky, const glm::dvec3& zenith, std::span<const glm::dvec3> directions, SkyRays& rays)
{
    const std::size_t count = directions.size();
    for (auto* axis : {&rays.x, &rays.y, &rays.z}) axis->resize(count);
    for (std::size_t k = 0; k < count; ++k) {
        const glm::vec3 w(directions[k]);
        rays.x[k] = w.x, rays.y[k] = w.y, rays.z[k] = w.z;
    }
    rays.up = glm::vec3(zenith);
    // Summed up as the kernel does, so that a surface that faces up receives exactly the colour.
    rays.full = 0;
    for (std::size_t k = 0; k < count; ++k)
        rays.full += (rays.x[k] * rays.up.x + rays.y[k] * rays.up.y) + rays.z[k] * rays.up.z;
    rays.color = sky.color;
    rays.ground = sky.ground;
    rays.bounce = sky.bounce;
}

} // namespace firsthit
