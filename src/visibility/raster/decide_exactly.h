// decide_exactly.h - decides what the float filters of the rasteriser leave open.
#pragma once

#include "visibility/raster/item_tile.h"
#include "visibility/bin/view_memory.h"

namespace firsthit {

/// The tile's samples of one SIMD register: sample k is at (x + k % columns, y + k / columns), its
/// memory at offset + k.
struct Lanes {
    int x, y, offset, columns;
};

/// For the samples in `open`: tests triangle i of the batch exactly where `inside` is not set, then
/// compares its w with the tile's, exactly where they are too close, and stores the nearer
/// triangle; at equal depth the lower id.
void decide_lanes_exactly(const ViewMemory& view, ItemTile& tile, int i, const Lanes& lanes,
    std::uint64_t open, std::uint64_t inside, const float* w);

/// A fragment whose w is too close to the tile's at that offset: compares exactly, and stores the
/// nearer triangle.
void decide_fragment_exactly(
    const ViewMemory& view, ItemTile& tile, std::uint32_t triangle, std::uint32_t offset, float w);

/// All samples of triangle i's box, each by exact arithmetic.
void decide_box(const ViewMemory& view, ItemTile& tile, int i);

} // namespace firsthit
