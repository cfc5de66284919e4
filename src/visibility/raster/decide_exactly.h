// decide_exactly.h - decides samples exactly where the rasteriser's floats are uncertain.
#pragma once

#include "visibility/bin/bins.h"
#include "visibility/raster/raster_scratch.h"

#include <cstdint>

namespace firsthit {

/// The samples of one SIMD register, of which some are not decided. Sample k is at (x + k %
/// columns, y + k / columns) of the tile, and has the index offset + k in the tile's memory.
struct OpenLanes {
    int x, y, offset, columns;
    std::uint64_t open;   // bit k: sample k is not decided
    std::uint64_t inside; // bit k: the triangle certainly covers sample k
    const float* w;       // 1/t of the triangle at the samples
};

/// Decides the open samples of a register for triangle i of the batch. Tests exactly whether the
/// triangle covers a sample, unless that is certain. Then compares its depth with that of the
/// stored triangle, exactly if their w are too close, and stores the nearer one; at equal depth the
/// one with the lower id. A cut-out is stored only where it is there.
void decide_lanes_exactly(const TileInWork& tile, int i, const OpenLanes& lanes);

/// Stores the nearer one of a fragment and the triangle that is stored at its place. For fragments
/// whose w is too close to the stored one.
void decide_fragment_exactly(const TileInWork& tile, const Fragment& fragment);

/// Rasterises triangle i of the batch over its box with exact arithmetic at every sample.
void decide_box(const TileInWork& tile, int i);

} // namespace firsthit
