// framing.cpp - how large a posed world is, and a camera that sees all of it.
#include <firsthit/scene.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace firsthit {
namespace {

constexpr double kFov_rad = 0.78539816339744831; // 45 degrees
constexpr double kMargin = 1.05;                 // the sphere leaves a rim of the picture free

} // namespace

std::array<glm::vec3, 2> bounds(const World& world)
{
    if (world.position.empty()) return {glm::vec3(0), glm::vec3(0)};
    glm::vec3 low = world.position[0];
    glm::vec3 high = low;
    for (const glm::vec3& p : world.position) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return {low, high};
}

Camera framing_camera(const World& world)
{
    // A sphere around the middle of the box, in double: the squares of floats fit.
    const auto [low, high] = bounds(world);
    const glm::dvec3 middle = 0.5 * (glm::dvec3(low) + glm::dvec3(high));
    double square = 0;
    for (const glm::vec3& p : world.position) {
        const glm::dvec3 d = glm::dvec3(p) - middle;
        square = std::max(square, glm::dot(d, d));
    }
    // A single point is seen from some way off, far enough for the eye to differ from it.
    double radius = std::sqrt(square);
    if (radius == 0) radius = std::max(1.0, 1e-3 * glm::length(middle));

    const glm::dvec3 towards_eye = glm::normalize(glm::dvec3(0, 0.3, 1));
    Camera camera;
    camera.fov_y_rad = kFov_rad;
    camera.eye = middle + towards_eye * (kMargin * radius / std::sin(kFov_rad / 2));
    camera.direction = -towards_eye;
    camera.up = {0, 1, 0};
    return camera;
}

} // namespace firsthit
