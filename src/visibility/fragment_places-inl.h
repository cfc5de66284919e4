// fragment_places-inl.h - fragments to their tiles, a register at a time where they share one.
#if defined(FIRSTHIT_FRAGMENT_PLACES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_FRAGMENT_PLACES_INL_H
#undef FIRSTHIT_FRAGMENT_PLACES_INL_H
#else
#define FIRSTHIT_FRAGMENT_PLACES_INL_H
#endif

#include <hwy/highway.h>

#include "base/tile_order.h"
#include "visibility/view_memory.h"

#include <algorithm>
#include <cstdint>

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

/// Whether the first `count` lanes are. Often in a mesh whose triangles follow each other.
HWY_INLINE bool are_in_one_tile(hn::Vec<Marks> place, std::uint32_t count)
{
    const Marks d;
    const auto tile = hn::ShiftRight<16>(place);
    const auto other = hn::Ne(tile, hn::Set(d, hn::GetLane(tile)));
    return hn::AllFalse(d, hn::And(other, hn::FirstN(d, count)));
}

/// Copies a range's fragments to their tiles, from where memory.fragment_cursor says.
inline void scatter_range(std::size_t range, ViewMemory& memory)
{
    const Marks d;
    const std::uint32_t lanes = std::uint32_t(hn::Lanes(d));
    std::uint32_t* HWY_RESTRICT cursor =
        &memory.fragment_cursor[range * std::size_t(memory.tiles())];
    const std::size_t first = range * memory.found_room;
    const std::uint32_t* HWY_RESTRICT place = memory.found.place.data() + first;
    const std::uint32_t* HWY_RESTRICT triangle = memory.found.triangle.data() + first;
    const float* HWY_RESTRICT w = memory.found.w.data() + first;
    Fragment* HWY_RESTRICT to = memory.fragment.data();
    const std::uint32_t count = memory.range_count[range].fragments;
    for (std::uint32_t k = 0; k < count; k += lanes) {
        const auto places = hn::LoadU(d, place + k);
        if (k + lanes <= count && are_in_one_tile(places, lanes)) {
            std::uint32_t& at = cursor[place[k] >> 16];
            hn::StoreInterleaved3(places, hn::LoadU(d, triangle + k),
                hn::BitCast(d, hn::LoadU(hn::Rebind<float, Marks>(), w + k)), d, &to[at].place);
            at += lanes;
        } else {
            for (std::uint32_t n = k; n < std::min(count, k + lanes); ++n)
                to[cursor[place[n] >> 16]++] = {place[n], triangle[n], w[n]};
        }
    }
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif
