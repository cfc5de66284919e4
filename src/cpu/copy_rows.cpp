// copy_rows.cpp - copies planes of a tile, which are in tile order, to rows of pixels of the film.
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

constexpr int kQuad = 4; // so many pixels are consecutive in the tile as well as in the row

/// Copies four pixels.
///
/// from    a plane for each channel
/// offset  of the first pixel in the planes
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

/// Copies four pixels past the caches. `to` is aligned to 16 bytes.
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
/// Indices for _mm512_permutex2var_ps that interleave three channels of 16 pixels, each in a
/// register, to three registers of pixels.
struct PixelOrder {
    alignas(64) std::int32_t first_two[3][16]; // merge channels 0 and 1
    alignas(64) std::int32_t third[3][16];     // merge the result and channel 2
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

/// Copies 16 pixels of three channels past the caches, as whole cache lines. `to` is aligned to 64
/// bytes.
///
/// quad  offsets of four pixels each in the planes
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

/// The first pixel of the rectangle's row y.
HWY_INLINE float* first_in_row(const PixelRect& rect, int y, int channels, const FilmRows& rows)
{
    const auto pixel =
        std::size_t(rect.film_y + y) * std::size_t(rows.width) + std::size_t(rect.film_x);
    return rows.value + pixel * std::size_t(channels);
}

template <int kChannels>
void copy_channels(
    const PixelRect& rect, int tile_size, const float* const* from, const FilmRows& to)
{
    for (int y = 0; y < rect.height; ++y) {
        float* film = first_in_row(rect, y, kChannels, to);
        const auto offset = [&](int x) { return std::size_t(tile_offset(x, y, tile_size)); };
        // Cache lines that neighbouring tiles share are written in part, which is still faster than
        // loading them.
        const bool past = to.stream && reinterpret_cast<std::uintptr_t>(film) % 16 == 0;
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
    if (to.stream) hwy::FlushStream(); // orders it before what other threads are told later
}

void copy(
    const PixelRect& rect, int tile_size, std::span<const float* const> from, const FilmRows& to)
{
    switch (from.size()) {
    case 1:
        return copy_channels<1>(rect, tile_size, from.data(), to);
    case 2:
        return copy_channels<2>(rect, tile_size, from.data(), to);
    default:
        return copy_channels<3>(rect, tile_size, from.data(), to);
    }
}

void fill(const PixelRect& rect, const glm::vec3& color, const FilmRows& to)
{
    const hn::CappedTag<float, kQuad> d;
    alignas(16) float quad[kQuad * 3];
    for (int k = 0; k < kQuad * 3; ++k) quad[k] = color[k % 3];
    for (int y = 0; y < rect.height; ++y) {
        float* film = first_in_row(rect, y, 3, to);
        const bool past = to.stream && reinterpret_cast<std::uintptr_t>(film) % 16 == 0;
        int x = 0;
        for (; past && x + kQuad <= rect.width; x += kQuad, film += kQuad * 3)
            for (std::size_t k = 0; k < kQuad * 3; k += hn::Lanes(d))
                hn::Stream(hn::Load(d, quad + k), d, film + k);
        for (; x < rect.width; ++x, film += 3) std::copy_n(quad, 3, film);
    }
    if (to.stream) hwy::FlushStream();
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(copy);
HWY_EXPORT(fill);

void copy_rows(
    const PixelRect& rect, int tile_size, std::span<const float* const> from, const FilmRows& to)
{
    HWY_DYNAMIC_DISPATCH(copy)(rect, tile_size, from, to);
}

void fill_rows(const PixelRect& rect, const glm::vec3& color, const FilmRows& to)
{
    HWY_DYNAMIC_DISPATCH(fill)(rect, color, to);
}

} // namespace firsthit
#endif
