// tile_stages.h - the stages of a frame of the cpu engine that work on one tile.
#pragma once

#include "cpu/frame_memory.h"
#include "cpu/frame_plan.h"
#include "frame/frame_context.h"
#include "visibility/item_source.h"

namespace firsthit {

/// A part of the picture in a pass of a frame.
struct FramePart {
    const FrameContext& frame;
    const FramePlan& plan;
    const PassPlan& pass;
    ItemSource& items;
    FrameMemory& memory;
    Region pixels; // the part, in pixels of the picture
};

/// A tile of the part, and the worker that handles it.
struct TileTurn {
    std::size_t tile;  // its number in the part
    std::size_t place; // where FrameMemory::hits, ::tiles and ::holes keep what belongs to it
    std::size_t worker;
};

/// Finds which triangle each sample of the tile sees. The result is in the worker's items.
void find_items(const FramePart& part, const TileTurn& turn);

/// Finds where exactly the rays hit the worker's items.
HitTile find_hits(const FramePart& part, const TileTurn& turn);

/// Finds how much of each light reaches the tile's hits; all of it if the pass has no shadows.
LightVisibility light_visibility(const FramePart& part, const TileTurn& turn);

/// Shades the tile's hits and stores its colours and planes in the film.
void shade_and_store(
    const FramePart& part, const TileTurn& turn, const HitTile& hits, const LightVisibility& lit);

} // namespace firsthit
