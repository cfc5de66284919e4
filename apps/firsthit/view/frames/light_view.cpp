// light_view.cpp - the scene as a light sees it.
#include "view/frames/light_view.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firsthit::cli::view {
namespace {

/// How far a directional light's eye is, in radii of the scene: rays differ by 1 / 20 rad at most.
constexpr double kFarRadii = 20;
/// The widest picture of a point light, and some room around the scene.
constexpr double kWidestRad = 2 * std::numbers::pi / 3, kAround = 1.05;

} // namespace

Camera camera_of_light(const Light& light, const Box& box)
{
    const glm::dvec3 middle = (box[0] + box[1]) * 0.5;
    const double radius = std::max(1e-9, glm::length(box[1] - box[0]) / 2);
    Camera camera;
    camera.eye = light.position;
    switch (light.kind) {
    case Light::Kind::spot:
        camera.direction = light.direction;
        camera.fov_y_rad = 2 * light.outer_rad;
        break;
    case Light::Kind::directional:
        camera.direction = glm::normalize(light.direction);
        camera.eye = middle - camera.direction * (kFarRadii * radius);
        camera.fov_y_rad = 2 * std::asin(1 / kFarRadii) * kAround;
        break;
    case Light::Kind::point: {
        const double far = glm::length(middle - light.position);
        camera.direction = far > 0 ? middle - light.position : glm::dvec3(0, 0, -1);
        const double angle = far > radius ? 2 * std::asin(radius / far) * kAround : kWidestRad;
        camera.fov_y_rad = std::min(kWidestRad, angle);
        break;
    }
    }
    const glm::dvec3 forward = glm::normalize(camera.direction);
    camera.up = std::abs(forward.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
    return camera;
}

} // namespace firsthit::cli::view
