// embree_frame.h - the cpu engine's frame, with a tree and rays in the place of rasterising.
#pragma once

#include "cpu/frame_memory.h"
#include "frame/frame_context.h"
#include "baseline/embree_tile.h"
#include "baseline/embree_tree.h"

#include <firsthit/options/baseline_options.h>
#include <firsthit/settings.h>

#include <memory>
#include <vector>

namespace firsthit {

/// What one worker needs to make a tile.
struct EmbreeWorker {
    ShadeMemory shade;
    EmbreeTileMemory tile;
    Buffer<float> lit; // (lights, samples)
    double primary_ms = 0, shadow_ms = 0, shade_ms = 0;
    std::uint64_t hits = 0, shadow_rays = 0;
};

/// Kept from frame to frame.
struct EmbreeFrameMemory {
    TileLayout view;
    HitMemory hits; // of a tile for each worker
    std::vector<std::unique_ptr<EmbreeWorker>> workers;
};

/// Who answers rays.
struct EmbreeRays {
    const EmbreeTree& tree; // up to date
    int packet;             // rays in a packet, 8 or 16
};

/// Renders the view's region into the film and adds to the statistics. `settings` and the frame's
/// view are checked; one sample a pixel; Shadows::map is not known here.
void render_embree(const FrameContext& frame, const Settings& settings, const EmbreeRays& rays,
    EmbreeFrameMemory& memory, BaselineStats& stats);

} // namespace firsthit
