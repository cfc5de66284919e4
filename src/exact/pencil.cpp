// pencil.cpp - a camera's frame and its samples.
#include "exact/pencil.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace firsthit {

namespace {

/// Far from where f times a vertex would leave what can be seen (kFarthest), yet a field of view
/// far below what the vertices' floats resolve.
constexpr double kLongestFocal = 1e15; // in samples

} // namespace

Pencil pencil_of(const View& view, const Region& region, int samples)
{
    const Camera& camera = view.camera;
    if (!(camera.fov_y_rad > 0 && camera.fov_y_rad < std::numbers::pi))
        throw ArgumentError(fmt::format(
            "field of view {} rad is out of range: between 0 and pi", camera.fov_y_rad));
    const glm::dvec3 right = glm::cross(camera.direction, camera.up);
    const double reach = glm::length(camera.direction) * glm::length(camera.up);
    if (!(glm::length(right) > 1e-12 * reach) || !std::isfinite(reach) ||
        !std::isfinite(glm::length(camera.eye)))
        throw ArgumentError("the camera needs a finite eye, and a direction and an up vector that "
                            "are neither zero nor parallel");

    Pencil pencil;
    const glm::dvec3 z = glm::normalize(camera.direction);
    const glm::dvec3 x = glm::normalize(right);
    const glm::dvec3 y = glm::cross(z, x); // down
    pencil.eye = camera.eye;
    pencil.f = 0.5 * view.height * samples / std::tan(0.5 * camera.fov_y_rad);
    if (!(pencil.f <= kLongestFocal))
        throw ArgumentError(fmt::format("field of view {} rad is too small: the focal length is "
                                        "{:g} samples, at most {:g} are accepted",
            camera.fov_y_rad, pencil.f, kLongestFocal));
    pencil.world_from_axes = glm::dmat3(x, y, z);
    pencil.eye_from_world = glm::transpose(glm::dmat3(pencil.f * x, pencil.f * y, z));
    pencil.width = region.width * samples;
    pencil.height = region.height * samples;
    pencil.x0 = double(region.x) * samples + 0.5 - 0.5 * view.width * samples;
    pencil.y0 = double(region.y) * samples + 0.5 - 0.5 * view.height * samples;
    return pencil;
}

} // namespace firsthit
