// embree_frame.h - the cpu engine's frame, with a tree and rays in the place of rasterising.
#pragma once

#include "base/tasks.h"
#include "cpu/frame.h"
#include "baseline/embree_tile.h"
#include "baseline/embree_tree.h"

#include <firsthit/baseline.h>

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
    ViewMemory view; // its pencil and tiles alone
    HitMemory hits;  // of a tile for each worker
    std::vector<std::unique_ptr<EmbreeWorker>> workers;
};

/// Renders the view's region into the film and adds to the statistics. `settings` and `view` are
/// checked, view.region is filled in; one sample a pixel; Shadows::map is not known here.
/// tree    is up to date
/// packet  rays in a packet, 8 or 16
void render_embree(const World& world, const View& view, const Settings& settings,
    const EmbreeTree& tree, int packet, EmbreeFrameMemory& memory, Tasks& tasks, Film& film,
    BaselineStats& stats);

} // namespace firsthit
