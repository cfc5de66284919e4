// point_shadows.h - shadows of points that are no pixels.
#pragma once

#include "shadow/exact_shadows.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// Which points a light does not reach: shadowed[k] = 1 where a triangle shadows points[k], else 0.
/// receivers  the triangle that each point lies on, which does not shadow it; or empty
void test_points(const World& world, const LightSpace& space, std::span<const glm::vec3> points,
    std::span<const std::uint32_t> receivers, ShadowMemory& memory, Tasks& tasks,
    std::span<std::uint8_t> shadowed);

} // namespace firsthit
