// dark_tile-inl.h - tiles that a map shows to be in shadow as a whole, without a look at its texels.
//
// Where a roof covers what is seen, tile after tile is dark. The texels that a tile's hits look at lie
// in some of the map's cells (store_depth.h): where the farthest depth of these cells is before all
// hits, every comparison of is_shadowed says dark. Other tiles are left to the comparisons, so the
// answer is always theirs. (That all is lit is seldom seen so: a lit surface is in the map itself.)
#if defined(FIRSTHIT_SHADOW_MAP_DARK_TILE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_SHADOW_MAP_DARK_TILE_INL_H_
#undef FIRSTHIT_SHADOW_MAP_DARK_TILE_INL_H_
#else
#define FIRSTHIT_SHADOW_MAP_DARK_TILE_INL_H_
#endif

#include "shadow/hit_hull-inl.h"
#include "shadow/map/store_depth.h"

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

/// Least and greatest of all lanes.
struct LaneRange {
    float least, greatest;
};

HWY_INLINE LaneRange lane_range(const real3 (&p)[HitHull::kRegisters], real real3::*axis)
{
    const RealTag d;
    real least = p[0].*axis, greatest = least;
    for (int k = 1; k < HitHull::kRegisters; ++k) {
        least = min(least, p[k].*axis);
        greatest = max(greatest, p[k].*axis);
    }
    return {hn::GetLane(hn::MinOfLanes(d, least.lanes)),
        hn::GetLane(hn::MaxOfLanes(d, greatest.lanes))};
}

/// The depths of a rectangle of a map, and of hits above it.
struct MapDepths {
    LaneRange hits;
    float farthest = std::numeric_limits<float>::infinity(); // of the map
};

/// hull       of the hits: (column, row, depth) of the map; the first two times the depth unless
///            `parallel`
/// reach      texels around a point that are looked at, and one for rounding
/// width, height  of the map, texels
HWY_INLINE MapDepths depths_under(
    HitHull hull, bool parallel, const FarthestDepths& farthest, int width, int height, float reach)
{
    MapDepths depths;
    depths.hits = lane_range(hull.p, &real3::z);
    if (!(depths.hits.greatest < 1e30f && depths.hits.least > (parallel ? -1e30f : 0.0f)))
        return depths; // some may have no shadow ray
    if (!parallel)
        for (real3& p : hull.p) {
            const real inv_depth = real(1.0f) / p.z;
            p.x = p.x * inv_depth;
            p.y = p.y * inv_depth;
        }
    const LaneRange column = lane_range(hull.p, &real3::x), row = lane_range(hull.p, &real3::y);
    const auto cell = [](float texel, int size) {
        const float most = float(size - 1);
        return int(texel > 0.0f ? std::min(texel, most) : 0.0f) / kCellSide;
    };
    const int x0 = cell(column.least - reach, width), x1 = cell(column.greatest + reach, width);
    const int y0 = cell(row.least - reach, height), y1 = cell(row.greatest + reach, height);
    constexpr int kMost = 16; // cells on a side, far more than a tile of a fitted map takes
    if (x1 - x0 >= kMost || y1 - y0 >= kMost) return depths;
    depths.farthest = farthest.at(x0, y0);
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x)
            depths.farthest = std::max(depths.farthest, farthest.at(x, y));
    return depths;
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
