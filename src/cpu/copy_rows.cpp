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

#if HWY_TARGET == HWY_AVX3
/// Three channels of 16 pixels, each in a register, become three registers of pixels.
struct PixelOrder {
    alignas(64) std::int32_t first_two[3][16]; // out of channels 0 and 1
    alignas(64) std::int32_t third[3][16];     // out of that and channel 2
};

constexpr PixelOrder kPixelOrder = [] {
    PixelOrder order{};
    for (int k = 0; k < 48; ++k) {
        const int channel = k % 3, pixel = k / 3;
        order.first_two[k / 16][k % 16] = channel == 1 ? 16 + pixel : pixel;
        order.third[k / 16][k % 16] = channel == 2 ? 16 + pixel : k % 16;
    }
    return order;
}();

/// 16 pixels past the caches, whole lines; `to` is aligned to 64 bytes.
/// quad  offsets of their quads in the tile
HWY_INLINE void stream_lines(const float* const* from, const std::size_t (&quad)[4], float* to)
{
    const auto row = [&](const float* plane) {
        const __m512 low = _mm512_castps128_ps512(_mm_load_ps(plane + quad[0]));
        return _mm512_insertf32x4(
            _mm512_insertf32x4(_mm512_insertf32x4(low, _mm_load_ps(plane + quad[1]), 1),
                _mm_load_ps(plane + quad[2]), 2),
            _mm_load_ps(plane + quad[3]), 3);
    };
    const __m512 c0 = row(from[0]), c1 = row(from[1]), c2 = row(from[2]);
    for (int line = 0; line < 3; ++line) {
        const __m512 two =
            _mm512_permutex2var_ps(c0, _mm512_load_si512(kPixelOrder.first_two[line]), c1);
        _mm512_stream_ps(to + 16 * line,
            _mm512_permutex2var_ps(two, _mm512_load_si512(kPixelOrder.third[line]), c2));
    }
}
#endif

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
#if HWY_TARGET == HWY_AVX3
            if constexpr (kChannels == 3) {
                while (past && x + 16 <= rect.width &&
                       reinterpret_cast<std::uintptr_t>(film) % 64 == 0) {
                    stream_lines(from,
                        {offset(x), offset(x + kQuad), offset(x + 2 * kQuad),
                            offset(x + 3 * kQuad)},
                        film);
                    x += 16, film += 16 * kChannels;
                }
                if (x + kQuad > rect.width) break;
            }
#endif
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

void fill(const PixelRect& rect, int film_width, const glm::vec3& color, float* to, bool stream)
{
    const hn::CappedTag<float, kQuad> d;
    alignas(16) float quad[kQuad * 3];
    for (int k = 0; k < kQuad * 3; ++k) quad[k] = color[k % 3];
    for (int y = 0; y < rect.height; ++y) {
        const auto pixel =
            std::size_t(rect.film_y + y) * std::size_t(film_width) + std::size_t(rect.film_x);
        float* film = to + pixel * 3;
        const bool past = stream && reinterpret_cast<std::uintptr_t>(film) % 16 == 0;
        int x = 0;
        for (; past && x + kQuad <= rect.width; x += kQuad, film += kQuad * 3)
            for (std::size_t k = 0; k < kQuad * 3; k += hn::Lanes(d))
                hn::Stream(hn::Load(d, quad + k), d, film + k);
        for (; x < rect.width; ++x, film += 3) std::copy_n(quad, 3, film);
    }
    if (stream) hwy::FlushStream();
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(copy);
HWY_EXPORT(fill);

void copy_rows(const PixelRect& rect, int film_width, int tile_size,
    std::span<const float* const> from, float* to, bool stream)
{
    HWY_DYNAMIC_DISPATCH(copy)(rect, film_width, tile_size, from, to, stream);
}

void fill_rows(
    const PixelRect& rect, int film_width, const glm::vec3& color, float* to, bool stream)
{
    HWY_DYNAMIC_DISPATCH(fill)(rect, film_width, color, to, stream);
}

} // namespace firsthit
#endif
