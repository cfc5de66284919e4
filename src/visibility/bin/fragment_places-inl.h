// fragment_places-inl.h - sorts fragments into their tiles, a register at a time.
#if defined(FIRSTHIT_FRAGMENT_PLACES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_FRAGMENT_PLACES_INL_H
#undef FIRSTHIT_FRAGMENT_PLACES_INL_H
#else
#define FIRSTHIT_FRAGMENT_PLACES_INL_H
#endif

#include <hwy/highway.h>

#include "base/tile_order.h"
#include "visibility/raster/sample_registers-inl.h"
#include "visibility/bin/bins.h"
#include "visibility/bin/eye_mesh.h"
#include "visibility/bin/tile_layout.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Marks = hn::CappedTag<std::uint32_t, 16>;

/// Computes Fragment::sample of samples.
struct Places {
    hn::Vec<Marks> size, inverse_size, blocks_x, tiles_x;

    explicit Places(const TileLayout& layout)
    {
        const Marks d;
        const auto set = [&](int v) { return hn::Set(d, std::uint32_t(v)); };
        size = set(layout.tile_size);
        inverse_size = set((1 << 22) / layout.tile_size + 1); // exact below 8192 samples
        blocks_x = set(layout.tile_size / kBlock);
        tiles_x = set(layout.tiles_x);
    }

    /// sample  x | y << 16
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
        // The order of samples in a block is that of base/tile_order.h.
        const auto in_block =
            hn::Or(hn::Or(hn::ShiftLeft<3>(bits(in_y, 4)), hn::ShiftLeft<2>(bits(in_x, 4))),
                hn::Or(hn::ShiftLeft<2>(bits(in_y, 3)), bits(in_x, 3)));
        const auto tile = hn::Add(hn::Mul(tile_y, tiles_x), tile_x);
        return hn::Or(hn::ShiftLeft<16>(tile), hn::Or(hn::ShiftLeft<6>(block), in_block));
    }
};

/// Calls f(tile, lanes), where `lanes` has a bit for each lane whose place is in that tile, until
/// all of the first `count` lanes are done. In a mesh whose neighbouring triangles follow each
/// other, a register has few tiles, often one. Where it has many, f is called for each single lane,
/// since that is quicker than finding out which lanes are in the same tile.
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
    std::uint64_t in_tile = lanes_in(tile[0]);
    if (in_tile != left && std::popcount(in_tile) < kFew) {
        for (std::uint32_t k = 0; k < count; ++k) f(tile[k], std::uint64_t(1) << k);
        return;
    }
    f(tile[0], in_tile);
    for (left &= ~in_tile; left; left &= ~in_tile) {
        const std::uint32_t next = tile[std::countr_zero(left)];
        in_tile = lanes_in(next);
        f(next, in_tile);
    }
}

/// Copies the fragments of a range to their tiles.
///
/// cursor  (tiles) the place in `to` where the range's next fragment of each tile goes; moves on
template <class AnyFragment>
inline void scatter_as(std::size_t range, const Bins& bins, std::uint32_t* HWY_RESTRICT cursor,
    AnyFragment* HWY_RESTRICT to)
{
    const Marks d;
    const hn::Rebind<float, Marks> f;
    const std::uint32_t lanes = std::uint32_t(hn::Lanes(d));
    const std::size_t first = range * bins.found_room;
    const std::uint32_t* HWY_RESTRICT place = bins.found.place.data() + first;
    const std::uint32_t* HWY_RESTRICT triangle = bins.found.triangle.data() + first;
    const float* HWY_RESTRICT w = bins.found.w.data() + first;
    const std::uint32_t count = bins.range_count[range].fragments;
    for (std::uint32_t k = 0; k < count; k += lanes) {
        const auto places = hn::LoadU(d, place + k);
        const std::uint32_t meant = std::min(count - k, lanes);
        for_tiles_of(places, meant, [&](std::uint32_t tile, std::uint64_t in_tile) {
            const auto number = std::uint32_t(std::popcount(in_tile));
            AnyFragment* HWY_RESTRICT at = to + cursor[tile];
            cursor[tile] += number;
            if (number == lanes) {
                const auto depths = hn::BitCast(d, hn::LoadU(f, w + k));
                if constexpr (std::is_same_v<AnyFragment, Fragment>)
                    hn::StoreInterleaved3(
                        places, hn::LoadU(d, triangle + k), depths, d, &at->sample);
                else
                    hn::StoreInterleaved2(places, depths, d, &at->sample);
                return;
            }
            for (; in_tile; in_tile &= in_tile - 1, ++at) {
                const std::uint32_t n = k + std::uint32_t(std::countr_zero(in_tile));
                if constexpr (std::is_same_v<AnyFragment, Fragment>)
                    *at = {place[n], triangle[n], w[n]};
                else
                    *at = {place[n], w[n]};
            }
        });
    }
}

/// See scatter_fragments.
inline void scatter_range(std::size_t range, std::size_t tiles, CornerSpace space, Bins& bins)
{
    std::uint32_t* cursor = &bins.fragment_cursor[range * tiles];
    if (space == CornerSpace::eye)
        scatter_as(range, bins, cursor, bins.fragment.data());
    else
        scatter_as(range, bins, cursor, bins.depth_fragment.data());
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif
