// brute_shadows.h - the oracle of shadows: tests every point against every triangle.
#pragma once

#include "base/tasks.h"
#include "exact/cutouts.h"
#include "exact/shadow_ray.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace firsthit {

/// Triangles in a light's space (see to_light).
struct LightTriangles {
    std::span<const glm::vec3> corner; // (V)
    std::span<const glm::uvec3> index; // (T)
    const Cutouts* cutouts = nullptr;  // of these triangles; null: all are opaque

    /// Whether the triangle shadows the point d.
    bool shadows(const PencilSpace& space, std::size_t t, const glm::vec3& d, Effort& effort) const
    {
        const Corners c = (*this)[t];
        return cutouts ? is_shadowed(space, *cutouts, {std::uint32_t(t), c}, d, effort)
                       : is_shadowed(space, c, d, effort);
    }

    Corners operator[](std::size_t triangle) const
    {
        const glm::uvec3& c = index[triangle];
        return {corner[c.x], corner[c.y], corner[c.z]};
    }
};

/// Moves points or vertices into the light's space, in the same order.
std::vector<glm::vec3> all_to_light(const PencilSpace& space, std::span<const glm::vec3> points);

/// Whether any triangle other than the receiver shadows the point d. This loop is the definition
/// that exact shadows have to equal.
/// receiver  the triangle that the point lies on, or kNoItem
bool is_shadowed_brute(const PencilSpace& space, const LightTriangles& triangles,
    const glm::vec3& d, std::uint32_t receiver, Effort& effort);

/// The same for many points: writes shadowed[k] = 1 or 0. Skips a triangle for a block of points
/// only if it certainly shadows none of them; everything else is decided point by point, by the
/// same functions as above.
/// points     (N) in the light's space
/// receivers  (N) as `receiver` above; empty: kNoItem for all points
/// progress   called now and then with the fraction that is done, in [0, 1]; may be empty
void brute_shadows(const PencilSpace& space, const LightTriangles& triangles,
    std::span<const glm::vec3> points, std::span<const std::uint32_t> receivers,
    std::span<std::uint8_t> shadowed, Tasks& tasks,
    const std::function<void(double)>& progress = {});

} // namespace firsthit
