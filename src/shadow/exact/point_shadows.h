// point_shadows.h - exact shadows at arbitrary points.
#pragma once

#include "shadow/exact/exact_shadows.h"
#include "shadow/exact/point_set.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// A world, and the space in which a light sees it.
struct LitWorld {
    const World& world;
    const PencilSpace& space;
};

/// Writes shadowed[k] = 1 if a triangle shadows points.given[k] from the light, else 0.
void test_points(const LitWorld& lit, const PointSet& points, ShadowMemory& memory, Tasks& tasks,
    std::span<std::uint8_t> shadowed);

} // namespace firsthit
