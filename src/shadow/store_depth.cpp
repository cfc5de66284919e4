// store_depth.cpp - from a rasterised tile to the map.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/store_depth.cpp"
#include "base/simd.h"

#include "shadow/store_depth.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

void store(const DepthTile& tile, const Pencil& pencil, const MapWindow& window)
{
    const hn::CappedTag<float, kQuadTexels> d;
    const auto nothing = hn::Set(d, std::numeric_limits<float>::infinity());
    const auto far = hn::Set(d, float(pencil.far)), one = hn::Set(d, 1.0f), zero = hn::Zero(d);
    for (int y = 0; y < window.height; y += 4) {
        for (int x = 0; x < window.width; x += 4) {
            const float* from = tile.w.data() + tile.column_offset[x] + tile.row_offset[y];
            float* to = window.depth + (y / 4 * window.quads_x + x / 4) * kQuadTexels;
            for (std::size_t k = 0; k < kQuadTexels; k += hn::Lanes(d)) {
                const auto w = hn::Load(d, from + k);
                const auto depth = pencil.parallel ? hn::Sub(far, w) : hn::Div(one, w);
                hn::Store(hn::IfThenElse(hn::Gt(w, zero), depth, nothing), d, to + k);
            }
        }
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(store);

void store_depth(const DepthTile& tile, const Pencil& pencil, const MapWindow& window)
{
    HWY_DYNAMIC_DISPATCH(store)(tile, pencil, window);
}

} // namespace firsthit
#endif
