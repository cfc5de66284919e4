// frame_memory.h - everything a frame of the cpu engine needs, allocated once and reused.
#pragma once

#include "cpu/holes.h"
#include "cpu/packed_tile.h"
#include "hits/resolve_tile.h"
#include "shade/shade_tile.h"
#include "shadow/light_visibility_stage.h"
#include "visibility/bin/view_memory.h"
#include "visibility/raster/item_tile.h"
#include "visibility/raster/raster_source.h"

#include <memory>
#include <vector>

namespace firsthit {

/// What shading writes before it goes to the film, in tile order.
struct ShadeMemory {
    Buffer<float> plane; // (planes, size * size)
    ShadeTargets targets;
};

/// What one worker needs to make a tile.
struct TileWorker {
    ItemTile items{};
    ShadeMemory shade;
    Buffer<float> lit; // (lights, samples) of a tile
    PackedTile packed; // of interleaved pictures
    double raster_ms = 0, resolve_ms = 0, shadow_ms = 0, shade_ms = 0;
    TileCounts counts;
    std::uint64_t hit_count = 0;
    std::uint64_t missed_count = 0;
};

struct FrameMemory {
    ViewMemory view;
    RasterSource raster;
    HitMemory hits;             // of all tiles where lights wait for them, else one a worker
    std::vector<HitTile> tiles; // of all tiles
    LightVisibilityMemory lit;
    HoleMemory holes;
    std::vector<std::unique_ptr<TileWorker>> workers;
};

} // namespace firsthit
