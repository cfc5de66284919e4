// framing.cpp - how large a posed world is, and a camera that sees all of it.
#include <firsthit/framing.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace firsthit {
namespace {

constexpr double kFov_rad = 0.78539816339744831; // 45 degrees
constexpr double kMargin = 1.05;                 // the sphere leaves a rim of the picture free

/// Where an eye has to be along `across` so that all vertices lie in the middle of its picture in that direction: the
/// outermost ones on both sides at the same angle. The eye has to be in front of all of them.
///
/// middle  of the world, which places along `across` and `back` are relative to
/// start   places of the eye: a first guess along `across`, and the one along `back`
double centred(const World& world, const glm::dvec3& middle, const glm::dvec3& across,
    const glm::dvec3& back, const glm::dvec2& start)
{
    constexpr int kMostSteps = 16; // two or three do
    double eye = start.x;
    const double far = start.y;
    for (int step = 0; step < kMostSteps; ++step) {
        // The outermost vertices as the eye sees them now; then the place from which these two are symmetric.
        double high = -std::numeric_limits<double>::infinity(), low = high;
        double at[2] = {}, depth[2] = {};
        for (const glm::vec3& position : world.position) {
            const glm::dvec3 p = glm::dvec3(position) - middle;
            const double x = glm::dot(p, across), z = far - glm::dot(p, back);
            if (const double slope = (x - eye) / z; slope > high)
                high = slope, at[0] = x, depth[0] = z;
            if (const double slope = (eye - x) / z; slope > low)
                low = slope, at[1] = x, depth[1] = z;
        }
        const double next = (at[0] * depth[1] + at[1] * depth[0]) / (depth[0] + depth[1]);
        if (!(std::abs(next - eye) > 1e-9 * far)) return eye;
        eye = next;
    }
    return eye;
}

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

Camera framing_camera(const World& world, const Framing& framing)
{
    const glm::dvec3 back = glm::normalize(framing.towards_eye);
    const glm::dvec3 right = glm::normalize(glm::cross(framing.up, back));
    const glm::dvec3 up = glm::cross(back, right);
    const double tan_y =
        framing.orthographic ? 0 : std::tan(framing.fov_y_rad / 2) * (1 - framing.margin);
    const double tan_x = tan_y * framing.aspect;

    // A vertex p = (x, y, z) along right, up and back is inside of the right side of the frustum of an eye e
    // if x - e.x <= tan_x (e.z - z), which is tan_x e.z + e.x >= x + tan_x z: the largest such sum of all
    // vertices bounds the eye. So do the other three sides; two opposite ones meet where e.z is least.
    const auto [low, high] = bounds(world);
    const glm::dvec3 middle = 0.5 * (glm::dvec3(low) + glm::dvec3(high));
    double right_most = 0, left_most = 0, top_most = 0, bottom_most = 0, nearest = 0, radius = 0;
    bool first = true;
    for (const glm::vec3& position : world.position) {
        const glm::dvec3 p = glm::dvec3(position) - middle;
        const double x = glm::dot(p, right), y = glm::dot(p, up), z = glm::dot(p, back);
        const auto widen = [&](double& most, double value) {
            most = first ? value : std::max(most, value);
        };
        widen(right_most, x + tan_x * z);
        widen(left_most, -x + tan_x * z);
        widen(top_most, y + tan_y * z);
        widen(bottom_most, -y + tan_y * z);
        widen(nearest, z);
        radius = std::max(radius, glm::length(p));
        first = false;
    }
    if (radius == 0) radius = std::max(1.0, 1e-3 * glm::length(middle));
    if (framing.orthographic) {
        Camera camera;
        double width = right_most + left_most, height = top_most + bottom_most;
        camera.eye = middle + back * (1.5 * radius);
        if (framing.all_around || !(std::max(width, height) > 0)) {
            width = height = 2 * radius;
        } else {
            camera.eye +=
                right * ((right_most - left_most) / 2) + up * ((top_most - bottom_most) / 2);
        }
        camera.orthographic_height =
            std::max(height, width / framing.aspect) / (1 - framing.margin);
        camera.direction = -back;
        camera.up = framing.up;
        return camera;
    }
    const double by_width = (right_most + left_most) / (2 * tan_x);
    const double by_height = (top_most + bottom_most) / (2 * tan_y);
    Camera camera;
    camera.fov_y_rad = framing.fov_y_rad;
    if (framing.all_around) {
        camera.eye = middle + back * (radius / std::sin(std::atan(std::min(tan_x, tan_y))));
    } else {
        // The eye stays off what has no width or height, and off a tip that points at it.
        const double distance = std::max({by_width, by_height, nearest + 0.1 * radius});
        double x = (right_most - left_most) / 2, y = (top_most - bottom_most) / 2;
        if (distance > by_width) x = centred(world, middle, right, back, {x, distance});
        if (distance > by_height) y = centred(world, middle, up, back, {y, distance});
        camera.eye = middle + right * x + up * y + back * distance;
    }
    camera.direction = -back;
    camera.up = framing.up;
    return camera;
}

} // namespace firsthit
