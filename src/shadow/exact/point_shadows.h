// point_shadows.h - shadows of points that are no pixels.
#pragma once

#include "shadow/exact/exact_shadows.h"
#include "shadow/exact/point_set.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// Which points a light does not reach: shadowed[k] = 1 where a triangle shadows the point that was
/// given as number k, else 0.
void test_points(const World& world, const PencilSpace& space, const PointSet& points,
    ShadowMemory& memory, Tasks& tasks, std::span<std::uint8_t> shadowed);

} // namespace firsthit
