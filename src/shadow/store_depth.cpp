// store_depth.cpp - from a rasterised tile to the map.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/store_depth.cpp"
#include "base/simd.h"

#include "shadow/store_depth.h"

#include <algorithm>
#include <cstring>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

void store(DepthTile& tile, const Pencil& pencil, const MapWindow& window)
{
    const hn::ScalableTag<float> d;
    const auto nothing = hn::Set(d, std::numeric_limits<float>::infinity());
    const auto far = hn::Set(d, float(pencil.far)), one = hn::Set(d, 1.0f), zero = hn::Zero(d);
    float* w = tile.w.data();
    for (std::size_t k = 0; k < tile.w.size(); k += hn::Lanes(d)) {
        const auto inverse = hn::Load(d, w + k);
        const auto depth = pencil.parallel ? hn::Sub(far, inverse) : hn::Div(one, inverse);
        hn::Store(hn::IfThenElse(hn::Gt(inverse, zero), depth, nothing), d, w + k);
    }
    // Four texels of a tile that start at a multiple of four lie side by side.
    for (int y = 0; y < window.height; ++y) {
        float* row = window.depth + std::size_t(y) * std::size_t(window.stride);
        for (int x = 0; x < window.width; x += 4) {
            const float* from = w + tile.column_offset[x] + tile.row_offset[y];
            if (x + 4 <= window.width)
                std::memcpy(row + x, from, 4 * sizeof(float));
            else
                std::copy_n(from, window.width - x, row + x);
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

void store_depth(DepthTile& tile, const Pencil& pencil, const MapWindow& window)
{
    HWY_DYNAMIC_DISPATCH(store)(tile, pencil, window);
}

} // namespace firsthit
#endif
