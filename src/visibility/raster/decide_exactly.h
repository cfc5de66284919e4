// decide_exactly.h - decides samples exactly where the rasteriser's floats are uncertain.
#pragma once

#include "visibility/raster/item_tile.h"
#include "visibility/bin/view_memory.h"

namespace firsthit {

/// The samples of one SIMD register: sample k is at (x + k % columns, y + k / columns) of the tile,
/// and at index offset + k of the tile's memory.
struct Lanes {
    int x, y, offset, columns;
};

/// Decides the samples whose bits are set in `open`. Where `inside` is not set, tests exactly
/// whether triangle i of the batch covers the sample. Then compares its w with the stored one,
/// exactly where they are too close, and stores the nearer triangle; at equal depth the one with
/// the lower id.
/// w  1/t of triangle i at the samples of the register
void decide_lanes_exactly(const ViewMemory& view, ItemTile& tile, int i, const Lanes& lanes,
    std::uint64_t open, std::uint64_t inside, const float* w);

/// Compares a fragment exactly with the triangle that is stored at its offset, because their w are
/// too close, and stores the nearer one.
void decide_fragment_exactly(
    const ViewMemory& view, ItemTile& tile, std::uint32_t triangle, std::uint32_t offset, float w);

/// Rasterises triangle i over its box with exact arithmetic at every sample.
void decide_box(const ViewMemory& view, ItemTile& tile, int i);

} // namespace firsthit
