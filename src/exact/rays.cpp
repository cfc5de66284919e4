// rays.cpp - a pencil's rays as floats.
#include "exact/rays.h"

namespace firsthit {

Rays world_rays(const Pencil& pencil, const LatticeTile& tile)
{
    const glm::mat3 axes(pencil.world_from_axes);
    return {.eye = glm::vec3(pencil.eye),
        .step_x = float(1 / pencil.f.x),
        .right = axes[0],
        .step_y = float(1 / pencil.f.y),
        .down = axes[1],
        .x0 = tile.x0,
        .forward = axes[2],
        .y0 = tile.y0,
        .parallel = pencil.parallel ? 1 : 0};
}

Rays transformed(
    const Rays& rays, const glm::dmat3& matrix, const glm::dvec3& origin, const glm::dvec3& offset)
{
    const glm::dmat3 axes = matrix * glm::dmat3(glm::dvec3(rays.right), glm::dvec3(rays.down),
                                         glm::dvec3(rays.forward));
    Rays to;
    to.eye = glm::vec3(matrix * (glm::dvec3(rays.eye) - origin) + offset);
    to.right = glm::vec3(axes[0] * double(rays.step_x));
    to.down = glm::vec3(axes[1] * double(rays.step_y));
    to.forward = glm::vec3(axes[2]);
    to.x0 = rays.x0;
    to.y0 = rays.y0;
    to.parallel = rays.parallel;
    return to;
}

} // namespace firsthit
