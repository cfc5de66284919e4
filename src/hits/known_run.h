// known_run.h - finds the planes of runs whose plane is not cached.
#pragma once

#include "base/pure.h"
#include "hits/hit_tile.h"

#include <firsthit/scene.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace firsthit {

/// Whether a normal n of the run's triangle points away from the eye. The sign of n . (p - eye)
/// says so for any p in the plane, unless it is as small as what the rounding of the eye to float
/// changes; then HitRun::eye_side decides.
///
/// n    in world space
/// n_p  n . (p - eye)
inline bool looks_away(const HitRun& run, const glm::dvec3& n, double n_p, const glm::vec3& eye)
{
    const double rounding =
        0x1p-23 * (std::abs(n.x * double(eye.x)) + std::abs(n.y * double(eye.y)) +
                      std::abs(n.z * double(eye.z)));
    if (std::abs(n_p) <= rounding && run.eye_side != 0) return run.eye_side > 0;
    return n_p > 0;
}

/// The same for the rays of a picture. For parallel ones, the sign of n . forward says so.
///
/// n_d  n . (p - eye), or n . forward of parallel rays
inline bool looks_away(const HitRun& run, const glm::dvec3& n, double n_d, const Rays& rays)
{
    if (!rays.parallel) return looks_away(run, n, n_d, rays.eye);
    const double rounding = 0x1p-22 * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
    if (std::abs(n_d) <= rounding && run.eye_side != 0) return run.eye_side > 0;
    return n_d > 0;
}

/// The run with its plane, computed from the triangle's corners in double, so that neither tiny nor
/// huge triangles leave the range of numbers. The plane is 0 if the triangle has no area or the eye
/// is in its plane. Of parallel rays the eye may be on either side of the plane: the height has a sign.
inline HitRun with_plane(HitRun run, const World& world, const Rays& rays)
{
    const glm::uvec3& corner = world.scene->index[run.item];
    const glm::dvec3 p0(world.position[corner.x]);
    const glm::dvec3 n = glm::cross(
        glm::dvec3(world.position[corner.y]) - p0, glm::dvec3(world.position[corner.z]) - p0);
    const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    const double n_p0 = glm::dot(n, p0 - glm::dvec3(rays.eye)), height = std::abs(n_p0 / largest);
    run.plane = glm::vec4(0);
    if (rays.parallel) {
        if (!(largest > 0 && height < 1e30)) return run;
        const double n_d = glm::dot(n, glm::dvec3(rays.forward));
        const double divisor = looks_away(run, n, n_d, rays) ? -largest : largest;
        run.plane = glm::vec4(n / divisor, -n_p0 / divisor);
    } else if (height > 1e-30 && height < 1e30) {
        run.plane =
            glm::vec4(n / (looks_away(run, n, n_p0, rays.eye) ? -largest : largest), height);
    }
    return run;
}

/// The run if its plane is cached. Otherwise `spare`, which becomes a copy of the run with its
/// plane.
FIRSTHIT_PURE const HitRun& known_run(
    const HitRun& run, const World& world, const Rays& rays, HitRun& spare)
{
    if (run.has_plane()) [[likely]]
        return run;
    spare = with_plane(run, world, rays);
    return spare;
}

} // namespace firsthit
