// bins.h - triangles sorted by the tiles that they may meet.
#pragma once

#include "base/buffer.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace firsthit {

/// A triangle that may hit a sample, and a box of samples that holds all that it may hit. 16 bytes.
struct InView {
    std::uint32_t triangle;
    std::int16_t x0, y0, x1, y1; // of the picture; x1 and y1 are inside the box
    float nearest_z; // at most the least z of the corners; 0 or less: some corner is behind the eye
};

/// A triangle that may hit a sample of a tile. 12 bytes.
struct TileEntry {
    std::uint32_t triangle;
    std::uint8_t x0, y0, x1, y1; // its box of samples, from the tile's first one; x1, y1 are inside
    float nearest_z;             // see InView
};

/// A sample that a tiny triangle certainly covers. 12 bytes.
struct Fragment {
    std::uint32_t sample; // tile << 16 | offset in the tile (base/tile_order.h)
    std::uint32_t triangle;
    float w; // 1/t
};

/// A texel of a shadow map that a tiny triangle covers. 8 bytes.
struct DepthFragment {
    std::uint32_t sample; // see Fragment
    float w;              // 1/t
};

/// Fragments in the order in which they are found, as a structure of arrays.
struct FoundFragments {
    Buffer<std::uint32_t, Pages::small> place;
    Buffer<std::uint32_t, Pages::small> triangle; // undefined for flat corners (CornerSpace)
    Buffer<float, Pages::small> w;

    void resize(std::size_t count)
    {
        place.resize(count);
        triangle.resize(count);
        w.resize(count);
    }
};

/// What was found in a range of triangles.
struct RangeCount {
    std::uint32_t in_view;   // triangles that have to be sorted into tiles
    std::uint32_t tiny;      // triangles that became fragments, and are not in the count above
    std::uint32_t fragments; // the fragments of those
};

/// The triangles that may hit a sample, by tile. Most triangles have an entry in each tile that
/// their box meets; tiny ones have a fragment for each sample that they cover instead.
struct Bins {
    // The result.
    Buffer<TileEntry> entry;          // (entries) by tile, then by triangle
    Buffer<std::uint32_t> tile_start; // (tiles + 1) the first entry of each tile
    Buffer<Fragment> fragment; // (fragments) by tile, then by range; for corners in eye space
    Buffer<DepthFragment> depth_fragment; // the same for flat corners
    Buffer<std::uint32_t> fragment_start; // (tiles + 1) the first fragment of each tile
    std::uint64_t in_view_count = 0;      // triangles that may hit a sample
    std::uint64_t entry_count = 0;

    // What the sort needs between its passes. Triangles are divided into ranges of kTriangleRange,
    // and each range has room in these buffers, which it fills from the start.
    Buffer<InView, Pages::small> in_view;  // (T)
    std::uint32_t found_room = 0;          // room for fragments in a range
    FoundFragments found;                  // (ranges, found_room)
    Buffer<RangeCount> range_count;        // (ranges)
    Buffer<std::uint32_t> cursor;          // (ranges, tiles) counts of entries, later where they go
    Buffer<std::uint32_t> fragment_cursor; // (ranges, tiles) the same for fragments
};

/// What one tile's bin holds.
template <class AnyFragment>
struct TileBin {
    std::span<const TileEntry> entries;
    std::span<const AnyFragment> fragments;
};

inline std::span<const TileEntry> entries_of(const Bins& bins, std::size_t tile)
{
    const std::uint32_t first = bins.tile_start[tile];
    return bins.entry.span().subspan(first, bins.tile_start[tile + 1] - first);
}

/// The bin of a tile, for corners in eye space.
inline TileBin<Fragment> bin_of(const Bins& bins, std::size_t tile)
{
    const std::uint32_t first = bins.fragment_start[tile];
    return {entries_of(bins, tile),
        bins.fragment.span().subspan(first, bins.fragment_start[tile + 1] - first)};
}

/// The bin of a tile, for flat corners.
inline TileBin<DepthFragment> depth_bin_of(const Bins& bins, std::size_t tile)
{
    const std::uint32_t first = bins.fragment_start[tile];
    return {entries_of(bins, tile),
        bins.depth_fragment.span().subspan(first, bins.fragment_start[tile + 1] - first)};
}

} // namespace firsthit
