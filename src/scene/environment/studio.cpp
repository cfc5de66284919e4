// studio.cpp - environments that are made of formulas.
#include <firsthit/environment.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firsthit {
namespace {

double smooth(double from, double to, double x)
{
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// A lamp with an even face: 1 inside of an ellipse around its direction, 0 outside, with soft borders.
///
/// half  sines of the half angles across and along
double soft_box(const glm::dvec3& d, const glm::dvec3& towards, double half_across, double half_up)
{
    const glm::dvec3 z = glm::normalize(towards);
    const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), z)), y = glm::cross(z, x);
    if (glm::dot(d, z) <= 0) return 0;
    const double far =
        std::max(std::abs(glm::dot(d, x)) / half_across, std::abs(glm::dot(d, y)) / half_up);
    return 1 - smooth(0.85, 1.15, far);
}

double studio_light(const glm::dvec3& d)
{
    // A floor that is lit from above, walls that brighten upwards, a ceiling.
    const double walls = 0.18 + 0.22 * smooth(-0.15, 0.9, d.y);
    const double floor = 0.13 + 0.05 * d.y;
    double light = floor + (walls - floor) * smooth(-0.12, 0.02, d.y);
    // The key light right above the camera's side (+z), one from the left, and one from behind.
    light += 1.6 * soft_box(d, {0.55, 1.0, 0.8}, 0.42, 0.3);
    light += 0.85 * soft_box(d, {-1.0, 0.35, 0.35}, 0.28, 0.5);
    light += 0.75 * soft_box(d, {0.3, 0.45, -1.0}, 0.5, 0.22);
    return light;
}

} // namespace

std::shared_ptr<const EnvironmentMap> constant_environment(const glm::vec3& radiance)
{
    return std::make_shared<const EnvironmentMap>("constant", 1, 1, std::span(&radiance, 1));
}

std::shared_ptr<const EnvironmentMap> studio_environment()
{
    constexpr int kWidth = 128, kHeight = 64;
    std::vector<glm::vec3> light;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const double down = std::numbers::pi * (y + 0.5) / kHeight,
                         around = std::numbers::pi * (2 * (x + 0.5) / kWidth - 1);
            const glm::dvec3 d(std::sin(down) * std::sin(around), std::cos(down),
                -std::sin(down) * std::cos(around));
            light.emplace_back(float(studio_light(d)));
        }
    return std::make_shared<const EnvironmentMap>("studio", kWidth, kHeight, light);
}

} // namespace firsthit
