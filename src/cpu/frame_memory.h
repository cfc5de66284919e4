// frame_memory.h - the memory of a frame of the cpu engine, which is kept from frame to frame.
#pragma once

#include "cpu/adaptive/adaptive_frame.h"
#include "cpu/holes.h"
#include "cpu/layers.h"
#include "hits/resolve_tile.h"
#include "shade/shade_tile.h"
#include "shadow/light_visibility_stage.h"
#include "shadow/sky/sky_stage.h"
#include "visibility/bin/view_memory.h"
#include "visibility/raster/raster_source.h"
#include "visibility/tile_items.h"

#include <memory>
#include <vector>

namespace firsthit {

/// What shading writes for one tile before it is stored in the film, in tile order.
struct ShadeMemory {
    Buffer<float> plane; // (planes, size * size)
    ShadeTargets targets;
};

/// The memory of one worker, and its times and counts since they were collected.
struct TileWorker {
    TileItems items;
    Buffer<std::uint64_t> wanted; // (blocks) TileItems::wanted of a pass over marked pixels
    ShadeMemory shade;
    Buffer<float> lit; // (lights, samples) of a tile, see LightVisibility
    double raster_ms = 0, resolve_ms = 0, shadow_ms = 0, shade_ms = 0;
    TileCounts counts;
    std::uint64_t hit_count = 0;
    std::uint64_t missed_count = 0;
};

/// The memory of a frame.
struct FrameMemory {
    ViewMemory view;
    RasterSource raster;
    HitMemory hits; // of all tiles of a part if PassPlan::keeps_hits, else a tile for each worker
    std::vector<HitTile>
        tiles;        // (tiles) of a part, where they are kept; of marked tiles those alone
    BlockBits wanted; // of a pass over marked pixels: the blocks that hold some
    std::vector<std::uint32_t> marked; // and the numbers of the tiles
    LightVisibilityMemory lit;
    SkyMemory sky;
    HoleMemory holes;
    LayerMemory layers;
    AdaptiveMemory adaptive;
    Film shot; // of a pass with steps
    std::vector<std::unique_ptr<TileWorker>> workers;
};

} // namespace firsthit
