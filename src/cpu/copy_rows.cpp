// copy_rows.cpp - a tile's planes, in the order of its samples, to rows of pixels.
#include "cpu/copy_rows.h"

#include "base/tile_order.h"

#include <algorithm>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/copy_rows.cpp"
#include "base/simd.h"

#include <hwy/cache_control.h>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr int kQuad = 4; // pixels that lie side by side in the tile and in the row

/// Four pixels.
template <int kChannels>
HWY_INLINE void copy_quad(const float* const* from, std::size_t offset, float* to)
{
    const hn::CappedTag<float, kQuad> d;
    if constexpr (hn::MaxLanes(d) < kQuad) {
        for (std::size_t k = 0; k < kQuad; ++k)
            for (int c = 0; c < kChannels; ++c)
                to[k * kChannels + std::size_t(c)] = from[c][offset + k];
    } else if constexpr (kChannels == 1) {
        hn::StoreU(hn::Load(d, from[0] + offset), d, to);
    } else if constexpr (kChannels == 2) {
        hn::StoreInterleaved2(hn::Load(d, from[0] + offset), hn::Load(d, from[1] + offset), d, to);
    } else {
        hn::StoreInterleaved3(hn::Load(d, from[0] + offset), hn::Load(d, from[1] + offset),
            hn::Load(d, from[2] + offset), d, to);
    }
}

/// Four pixels past the caches; `to` is aligned to 16 bytes.
template <int kChannels>
HWY_INLINE void stream_quad(const float* const* from, std::size_t offset, float* to)
{
    const hn::CappedTag<float, kQuad> d;
    alignas(64) float quad[kQuad * kChannels];
    copy_quad<kChannels>(from, offset, quad);
    for (std::size_t k = 0; k < kQuad * kChannels; k += hn::Lanes(d))
        hn::Stream(hn::Load(d, quad + k), d, to + k);
}

template <int kChannels>
void copy_channels(const PixelRect& rect, int film_width, int tile_size, const float* const* from,
    float* to, bool stream)
{
    for (int y = 0; y < rect.height; ++y) {
        const auto pixel =
            std::size_t(rect.film_y + y) * std::size_t(film_width) + std::size_t(rect.film_x);
        float* film = to + pixel * kChannels;
        const auto offset = [&](int x) { return std::size_t(tile_offset(x, y, tile_size)); };
        // Lines that neighbouring tiles share are written in part: still faster than fetching them.
        const bool past = stream && reinterpret_cast<std::uintptr_t>(film) % 16 == 0;
        int x = 0;
        for (; x + kQuad <= rect.width; x += kQuad, film += kQuad * kChannels) {
            if (past)
                stream_quad<kChannels>(from, offset(x), film);
            else
                copy_quad<kChannels>(from, offset(x), film);
        }
        for (; x < rect.width; ++x)
            for (int c = 0; c < kChannels; ++c) *film++ = from[c][offset(x)];
    }
    if (stream) hwy::FlushStream(); // other threads see it in its turn
}

void copy(const PixelRect& rect, int film_width, int tile_size, std::span<const float* const> from,
    float* to, bool stream)
{
    switch (from.size()) {
    case 1:
        return copy_channels<1>(rect, film_width, tile_size, from.data(), to, stream);
    case 2:
        return copy_channels<2>(rect, film_width, tile_size, from.data(), to, stream);
    default:
        return copy_channels<3>(rect, film_width, tile_size, from.data(), to, stream);
    }
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(copy);

void copy_rows(const PixelRect& rect, int film_width, int tile_size,
    std::span<const float* const> from, float* to, bool stream)
{
    HWY_DYNAMIC_DISPATCH(copy)(rect, film_width, tile_size, from, to, stream);
}

} // namespace firsthit
#endif
