// frame.h - the cpu engine: a picture from a posed world, tile by tile.
#pragma once

#include "base/tasks.h"
#include "cpu/holes.h"
#include "cpu/packed_tile.h"
#include "hits/resolve_tile.h"
#include "shade/shade_tile.h"
#include "shadow/light_visibility_stage.h"
#include "visibility/raster/item_tile.h"
#include "visibility/raster/raster_source.h"
#include "visibility/bin/view_memory.h"

#include <firsthit/render.h>

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

/// Everything a frame needs, allocated once and reused.
struct FrameMemory {
    ViewMemory view;
    RasterSource raster;
    HitMemory hits;             // of all tiles where lights wait for them, else one a worker
    std::vector<HitTile> tiles; // of all tiles
    LightVisibilityMemory lit;
    HoleMemory holes;
    std::vector<std::unique_ptr<TileWorker>> workers;
};

/// Who makes what a frame is made of; null: the cpu engine.
struct FrameSources {
    ItemSource* items = nullptr;
    MapMaker* maps = nullptr;
};

/// Renders the view's region into the film and adds to the statistics. `settings` and `view` are
/// checked (render/check_settings.h); view.region is filled in. Shadows::automatic is exact.
void render_frame(const World& world, const View& view, const Settings& settings,
    FrameMemory& memory, Tasks& tasks, Film& film, Stats& stats, const FrameSources& sources = {});

} // namespace firsthit
