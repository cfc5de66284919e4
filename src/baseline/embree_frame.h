// embree_frame.h - the frame of the baseline: that of the cpu engine, but Embree's tree and rays
// replace rasterising.
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

/// The memory of one worker, and its times and counts in a frame.
struct EmbreeWorker {
    ShadeMemory shade;
    EmbreeTileMemory tile;
    Buffer<float> lit; // (lights, samples)
    double primary_ms = 0, shadow_ms = 0, shade_ms = 0;
    std::uint64_t hits = 0, shadow_rays = 0;
};

/// The memory of a frame, kept from frame to frame.
struct EmbreeFrameMemory {
    TileLayout layout;
    HitMemory hits; // a tile for each worker
    std::vector<std::unique_ptr<EmbreeWorker>> workers;
};

/// The tree that rays are shot into, and how.
struct EmbreeRays {
    const EmbreeTree& tree; // updated for the frame's world
    int packet;             // rays in a packet, 8 or 16
};

/// Renders the view's region into the film, and adds to the statistics.
///
/// frame     its view is checked; one sample a pixel
/// settings  checked; Shadows::map is not supported
void render_embree(const FrameContext& frame, const Settings& settings, const EmbreeRays& rays,
    EmbreeFrameMemory& memory, BaselineStats& stats);

} // namespace firsthit
