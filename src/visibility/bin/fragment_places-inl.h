// fragment_places-inl.h - fragments to their tiles, a register at a time.
#if defined(FIRSTHIT_FRAGMENT_PLACES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_FRAGMENT_PLACES_INL_H
#undef FIRSTHIT_FRAGMENT_PLACES_INL_H
#else
#define FIRSTHIT_FRAGMENT_PLACES_INL_H
#endif

#include <hwy/highway.h>

#include "base/tile_order.h"
#include "visibility/raster/sample_registers-inl.h"
#include "visibility/bin/view_memory.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Marks = hn::CappedTag<std::uint32_t, 16>;

/// From samples to their places: tile << 16 | offset.
struct Places {
    hn::Vec<Marks> size, inverse_size, blocks_x, tiles_x;

    explicit Places(const ViewMemory& memory)
    {
        const Marks d;
        const auto set = [&](int v) { return hn::Set(d, std::uint32_t(v)); };
        size = set(memory.tile_size);
        inverse_size = set((1 << 22) / memory.tile_size + 1); // exact below 8192 samples
        blocks_x = set(memory.tile_size / kBlock);
        tiles_x = set(memory.tiles_x);
    }

    HWY_INLINE hn::Vec<Marks> of(hn::Vec<Marks> sample) const
    {
        const Marks d;
        const auto bits = [&](auto v, std::uint32_t mask) { return hn::And(v, hn::Set(d, mask)); };
        const auto x = bits(sample, 0xFFFF), y = hn::ShiftRight<16>(sample);
        const auto tile_x = hn::ShiftRight<22>(hn::Mul(x, inverse_size));
        const auto tile_y = hn::ShiftRight<22>(hn::Mul(y, inverse_size));
        const auto in_x = hn::Sub(x, hn::Mul(tile_x, size));
        const auto in_y = hn::Sub(y, hn::Mul(tile_y, size));
        const auto block =
            hn::Add(hn::Mul(hn::ShiftRight<3>(in_y), blocks_x), hn::ShiftRight<3>(in_x));
        // tile_order.h
        const auto in_block =
            hn::Or(hn::Or(hn::ShiftLeft<3>(bits(in_y, 4)), hn::ShiftLeft<2>(bits(in_x, 4))),
                hn::Or(hn::ShiftLeft<2>(bits(in_y, 3)), bits(in_x, 3)));
        const auto tile = hn::Add(hn::Mul(tile_y, tiles_x), tile_x);
        return hn::Or(hn::ShiftLeft<16>(tile), hn::Or(hn::ShiftLeft<6>(block), in_block));
    }
};

/// Calls f(tile, lanes that are in it) for each tile of the first `count` lanes, or for each lane. In
/// a mesh whose triangles follow each other there are few tiles, often one; where there are many, it
/// is quicker not to ask.
template <class F>
HWY_INLINE void for_tiles_of(hn::Vec<Marks> place, std::uint32_t count, const F& f)
{
    constexpr int kFew = hn::MaxLanes(Marks()) / 2;
    const Marks d;
    alignas(64) std::uint32_t tile[hn::MaxLanes(d)];
    const auto tiles = hn::ShiftRight<16>(place);
    hn::Store(tiles, d, tile);
    std::uint64_t left = (std::uint64_t(1) << count) - 1;
    const auto lanes_in = [&](std::uint32_t of) {
        return left & bits(d, hn::Eq(tiles, hn::Set(d, of)));
    };
    std::uint64_t in_it = lanes_in(tile[0]);
    if (in_it != left && std::popcount(in_it) < kFew) {
        for (std::uint32_t k = 0; k < count; ++k) f(tile[k], std::uint64_t(1) << k);
        return;
    }
    f(tile[0], in_it);
    for (left &= ~in_it; left; left &= ~in_it) {
        const std::uint32_t next = tile[std::countr_zero(left)];
        in_it = lanes_in(next);
        f(next, in_it);
    }
}

/// Copies a range's fragments to their tiles, from where memory.fragment_cursor says.
template <class Part>
inline void scatter_as(std::size_t range, const ViewMemory& memory,
    std::uint32_t* HWY_RESTRICT cursor, Part* HWY_RESTRICT to)
{
    const Marks d;
    const hn::Rebind<float, Marks> f;
    const std::uint32_t lanes = std::uint32_t(hn::Lanes(d));
    const std::size_t first = range * memory.found_room;
    const std::uint32_t* HWY_RESTRICT place = memory.found.place.data() + first;
    const std::uint32_t* HWY_RESTRICT triangle = memory.found.triangle.data() + first;
    const float* HWY_RESTRICT w = memory.found.w.data() + first;
    const std::uint32_t count = memory.range_count[range].fragments;
    for (std::uint32_t k = 0; k < count; k += lanes) {
        const auto places = hn::LoadU(d, place + k);
        const std::uint32_t meant = std::min(count - k, lanes);
        for_tiles_of(places, meant, [&](std::uint32_t tile, std::uint64_t in_it) {
            const auto number = std::uint32_t(std::popcount(in_it));
            Part* HWY_RESTRICT at = to + cursor[tile];
            cursor[tile] += number;
            if (number == lanes) {
                const auto depths = hn::BitCast(d, hn::LoadU(f, w + k));
                if constexpr (std::is_same_v<Part, Fragment>)
                    hn::StoreInterleaved3(
                        places, hn::LoadU(d, triangle + k), depths, d, &at->place);
                else
                    hn::StoreInterleaved2(places, depths, d, &at->place);
                return;
            }
            for (; in_it; in_it &= in_it - 1, ++at) {
                const std::uint32_t n = k + std::uint32_t(std::countr_zero(in_it));
                if constexpr (std::is_same_v<Part, Fragment>)
                    *at = {place[n], triangle[n], w[n]};
                else
                    *at = {place[n], w[n]};
            }
        });
    }
}

inline void scatter_range(std::size_t range, ViewMemory& memory)
{
    std::uint32_t* cursor = &memory.fragment_cursor[range * std::size_t(memory.tiles())];
    if (memory.corner_space == CornerSpace::eye)
        scatter_as(range, memory, cursor, memory.fragment.data());
    else
        scatter_as(range, memory, cursor, memory.depth_fragment.data());
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif
