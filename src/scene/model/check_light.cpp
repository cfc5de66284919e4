// check_light.cpp - does a light keep its promises?
#include "scene/model/check_light.h"

#include <firsthit/error.h>

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace firsthit {
namespace {

constexpr double kHalfPi = 1.57079632679489662;

/// Its square has to be a double above 0.
constexpr double kLeastLength = 1e-100;
constexpr double kGreatestLength = 1e100;

std::string text_of(const glm::dvec3& v)
{
    return fmt::format("({}, {}, {})", v.x, v.y, v.z);
}

bool finite(const glm::dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool has_length(const glm::dvec3& v)
{
    const glm::dvec3 size = glm::abs(v);
    const double largest = std::max({size.x, size.y, size.z});
    return finite(v) && largest >= kLeastLength && largest <= kGreatestLength;
}

} // namespace

std::string fault_of(const Light& light)
{
    if (!finite(light.position))
        return fmt::format("its position {} is not finite", text_of(light.position));
    if (!finite(light.color))
        return fmt::format("its colour {} is not finite", text_of(light.color));
    if (!(std::isfinite(light.range) && light.range >= 0))
        return fmt::format("its range {} is none: 0 (no end) or more is accepted", light.range);
    if (light.kind == Light::Kind::point) return {};
    if (!has_length(light.direction))
        return fmt::format("its direction {} is none: accepted is a length from {} to {}",
            text_of(light.direction), kLeastLength, kGreatestLength);
    if (light.kind == Light::Kind::directional) return {};
    const double inner = light.inner_rad, outer = light.outer_rad;
    if (!(0 <= inner && inner <= outer && 0 < outer && outer < kHalfPi))
        return fmt::format("its cone of half angles {} and {} rad is none: accepted are "
                           "0 <= inner <= outer, and outer above 0 and below pi / 2",
            inner, outer);
    return {};
}

void check_lights(const World& world)
{
    for (std::size_t l = 0; l < world.lights.size(); ++l) {
        const std::string fault = fault_of(world.lights[l]);
        if (fault.empty()) continue;
        const std::string& name = world.scene->name;
        throw SceneError(fmt::format("{}: light {}: {}", name.empty() ? "scene" : name, l, fault));
    }
}

} // namespace firsthit
