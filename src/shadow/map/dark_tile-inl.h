// dark_tile-inl.h - finds tiles that are wholly in shadow by testing 16x16 texel cells of a map.
//
// The texels that a tile's hits sample lie in a few of the map's cells (store_depth.h). If the
// farthest depth of these cells is in front of all hits, every comparison of is_shadowed_by_texel
// would find shadow, so the texels need not be read. Many tiles under a roof are like this. All
// other tiles are sampled texel by texel, so this never changes the answer. (The opposite test, for
// tiles that are wholly lit, would seldom succeed, because a lit surface is in the map itself.)
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

/// Least and greatest value of all lanes.
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

/// The depths of a tile's hits, and the farthest depth of the map's cells under them.
struct MapDepths {
    LaneRange hits;
    float farthest = std::numeric_limits<float>::infinity(); // of the map's cells
};

/// The cells of a map.
struct MapCells {
    const FarthestDepths& farthest;
    int width, height; // of the map, in texels
    bool parallel;     // whether the light is parallel
};

/// hull     of the hits, in (column, row, depth) of the map; column and row are multiplied by the
///          depth unless the light is parallel
/// reach    how many texels around a point are sampled, plus one for rounding
/// returns  farthest = +inf where the hull has no bounds in the map or covers too many cells
HWY_INLINE MapDepths depths_under(HitHull hull, const MapCells& map, float reach)
{
    const bool parallel = map.parallel;
    MapDepths depths;
    depths.hits = lane_range(hull.p, &real3::z);
    if (!(depths.hits.greatest < 1e30f && depths.hits.least > (parallel ? -1e30f : 0.0f)))
        return depths; // some hits may have no shadow ray
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
    const int x0 = cell(column.least - reach, map.width),
              x1 = cell(column.greatest + reach, map.width);
    const int y0 = cell(row.least - reach, map.height), y1 = cell(row.greatest + reach, map.height);
    constexpr int kMost = 16; // cells on a side; far more than a tile covers in a fitted map
    if (x1 - x0 >= kMost || y1 - y0 >= kMost) return depths;
    depths.farthest = map.farthest.at(x0, y0);
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x)
            depths.farthest = std::max(depths.farthest, map.farthest.at(x, y));
    return depths;
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
