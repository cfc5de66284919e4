// store_depth.cpp - copies a rasterised tile into a map.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/map/store_depth.cpp"
#include "base/simd.h"

#include "shadow/map/store_depth.h"

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Converts the tile's 1/t to depths, a register at a time.
struct Depths {
    using D = hn::CappedTag<float, kQuadTexels>;
    using V = hn::Vec<D>;
    D d;
    V nothing = hn::Set(d, std::numeric_limits<float>::infinity());
    V one = hn::Set(d, 1.0f), zero = hn::Zero(d), far;
    bool parallel;

    explicit Depths(const Pencil& pencil)
        : far(hn::Set(d, float(pencil.far))),
          parallel(pencil.parallel)
    {
    }
    HWY_INLINE V operator()(V w) const
    {
        const V depth = parallel ? hn::Sub(far, w) : hn::Div(one, w);
        return hn::IfThenElse(hn::Gt(w, zero), depth, nothing);
    }
};

/// Writes the quads of the cell whose first texel is (x0, y0) of the window, and returns their
/// farthest depth.
float store_cell(
    const DepthTile& tile, const Depths& depths, const MapWindow& window, int x0, int y0)
{
    const int x1 = std::min(x0 + kCellSide, window.width);
    const int y1 = std::min(y0 + kCellSide, window.height);
    const Depths::D d;
    auto farthest = hn::Neg(depths.nothing);
    for (int y = y0; y < y1; y += 4) {
        for (int x = x0; x < x1; x += 4) {
            const float* from = tile.w.data() + tile.column_offset[x] + tile.row_offset[y];
            float* to = window.depth + (y / 4 * window.quads_x + x / 4) * kQuadTexels;
            for (std::size_t k = 0; k < kQuadTexels; k += hn::Lanes(d)) {
                const auto depth = depths(hn::Load(d, from + k));
                farthest = hn::Max(farthest, depth);
                hn::Store(depth, d, to + k);
            }
        }
    }
    return hn::GetLane(hn::MaxOfLanes(d, farthest));
}

void store(const DepthTile& tile, const Pencil& pencil, const MapWindow& window)
{
    const Depths depths(pencil);
    for (int y = 0; y < window.height; y += kCellSide)
        for (int x = 0; x < window.width; x += kCellSide)
            window.farthest[y / kCellSide * window.cells_x + x / kCellSide] =
                store_cell(tile, depths, window, x, y);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(store);

void find_farthest(const float* depth, int width, int height, FarthestDepths& farthest)
{
    farthest.resize(width, height);
    std::fill_n(
        farthest.depth.data(), farthest.depth.size(), -std::numeric_limits<float>::infinity());
    for (int y = 0; y < height; y += 4)
        for (int x = 0; x < width; x += 4, depth += kQuadTexels) {
            float& cell = farthest.at(x / kCellSide, y / kCellSide);
            cell = std::max(cell, *std::max_element(depth, depth + kQuadTexels));
        }
}

void store_depth(const DepthTile& tile, const Pencil& pencil, const MapWindow& window)
{
    HWY_DYNAMIC_DISPATCH(store)(tile, pencil, window);
}

} // namespace firsthit
#endif
