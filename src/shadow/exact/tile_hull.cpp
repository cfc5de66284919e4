// tile_hull.cpp - a convex hull around the hits of a tile.
#include "shadow/exact/tile_hull.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/exact/tile_hull.cpp"
#include "base/simd.h"

#include "shadow/hit_hull-inl.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

std::array<float, 2> depths_of(const HitTile& hits)
{
    const HitDepths depths = tile_depths(hits);
    return {depths.nearest, depths.farthest};
}

/// The largest absolute value of some numbers.
float largest_of(const float* value, std::size_t count)
{
    const RealTag d;
    auto most = hn::Zero(d);
    std::size_t k = 0;
    for (; k + std::size_t(kLanes) <= count; k += std::size_t(kLanes))
        most = hn::Max(hn::Abs(hn::LoadU(d, value + k)), most);
    float largest = hn::GetLane(hn::MaxOfLanes(d, most));
    for (; k < count; ++k) largest = std::max(largest, std::abs(value[k]));
    return largest;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(depths_of);
HWY_EXPORT(largest_of);

TileHull tile_hull(const HitTile& hits)
{
    TileHull hull;
    if (hits.runs.empty()) return hull;
    const auto [nearest, farthest] = HWY_DYNAMIC_DISPATCH(depths_of)(hits);
    const Rays& rays = hits.rays;
    double largest = 0;
    for (std::size_t k = 0; k < 8; ++k) {
        const double last = hits.size - 1, x = rays.x0 + (k & 1 ? last : 0),
                     y = rays.y0 + (k & 2 ? last : 0),
                     t = k & 4 ? double(farthest) : double(nearest);
        hull.corner[k] = rays.point(x, y, t);
        const glm::dvec3 sum = rays.point_size(x, y, t);
        largest = std::max({largest, sum.x, sum.y, sum.z});
    }
    hull.rounding = kPositionRounding * largest;
    hull.empty = false;
    return hull;
}

float largest_coordinate(std::span<const glm::vec3> points)
{
    return points.empty() ? 0 : HWY_DYNAMIC_DISPATCH(largest_of)(&points[0].x, 3 * points.size());
}

float farthest_coordinate(const Light& light, std::span<const glm::vec3> points)
{
    constexpr std::size_t kChunk = 4096;
    float farthest = 0;
    for (std::size_t first = 0; first < points.size(); first += kChunk) {
        farthest = std::max(farthest,
            largest_coordinate(points.subspan(first, std::min(kChunk, points.size() - first))));
        if (!is_far_lamp(light, farthest)) return std::numeric_limits<float>::infinity();
    }
    return farthest;
}

} // namespace firsthit
#endif
