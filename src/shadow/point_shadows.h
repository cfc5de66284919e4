// point_shadows.h - which points of any set are in shadow?
#pragma once

#include "base/tasks.h"
#include "exact/shadow_ray.h"

#include <firsthit/scene.h>

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit {

/// What test_points keeps from call to call.
struct PointShadowMemory {
    std::vector<glm::vec3> corner; // (V) in the light's space
    std::vector<glm::vec3> point;  // (N) in the light's space
};

/// Decides for each point whether a triangle shadows it, exactly as is_shadowed_brute says.
///
/// points     (N) world space
/// receivers  (N) the triangle that each point lies on, which is skipped, or kNoItem; or empty
/// shadowed   (N) 1 or 0; 0 for a point without a shadow ray (has_shadow_ray)
void test_points(const World& world, const LightSpace& space, std::span<const glm::vec3> points,
    std::span<const std::uint32_t> receivers, PointShadowMemory& memory, Tasks& tasks,
    std::span<std::uint8_t> shadowed);

} // namespace firsthit
