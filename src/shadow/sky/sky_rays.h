// sky_rays.h - a sky in the form that shading needs.
#pragma once

#include "hits/sky_visibility.h"

#include <firsthit/light.h>
#include <firsthit/options/sky_options.h>

#include <span>
#include <vector>

namespace firsthit {

/// The unit vector towards the sky's zenith.
/// camera_up  the zenith of a sky without an `up` of its own
/// throws     ArgumentError: 0 or not finite
glm::dvec3 zenith_of(const Sky& sky, const glm::dvec3& camera_up);

/// throws  ArgumentError: out of range
void check_sky_directions(int count);

/// As sky_directions; allocates only to grow.
void fill_sky_directions(int count, const glm::dvec3& zenith, std::vector<glm::dvec3>& directions);

/// directions  of fill_sky_directions
void set_up_sky(const Sky& sky, const glm::dvec3& zenith, std::span<const glm::dvec3> directions,
    SkyRays& rays);

/// The light of direction w of the sky, which shadow tests take.
inline Light sky_ray_light(const glm::dvec3& w)
{
    return {.kind = Light::Kind::directional, .direction = -w};
}

/// What is left of the light of the sky and of the ground (firsthit/options/sky_options.h).
struct SkyShares {
    float sky = 0;    // S / F
    float ground = 0; // the whole factor of the ground
};

/// open  the sum of max(0, n.w) over all directions
/// seen  that over those that nothing hides
/// n_up  n.up
inline SkyShares sky_shares(const SkyRays& rays, float open, float seen, float n_up)
{
    const float rest = 0.02f * rays.full, sum = seen + rays.bounce * (open - seen);
    return {sum / rays.full, (0.5f - 0.5f * n_up) * ((sum + rest) / (open + rest))};
}

} // namespace firsthit
