// tile_stages.h - what a frame of the cpu engine does with each tile.
#pragma once

#include "cpu/frame_memory.h"
#include "cpu/frame_plan.h"
#include "frame/frame_context.h"
#include "visibility/item_source.h"

namespace firsthit {

/// A part of the picture while a pass is at it.
struct FramePart {
    const FrameContext& frame;
    const FramePlan& plan;
    const PassPlan& pass;
    ItemSource& items;
    FrameMemory& memory;
    Region pixels; // of the picture
};

/// A tile of the part, and who works at it.
struct TileTurn {
    std::size_t tile;
    std::size_t place; // of its hits and holes in the memory
    std::size_t worker;
};

/// Which triangle does each sample see? In the worker's items.
void find_items(const FramePart& part, const TileTurn& turn);

/// Where exactly? Of the worker's items.
HitTile find_hits(const FramePart& part, const TileTurn& turn);

/// How much of each light reaches the tile's hits; without shadows all of it.
LightVisibility light_visibility(const FramePart& part, const TileTurn& turn);

/// What colour is it? The tile's colours and planes, to the film.
void shade_and_store(
    const FramePart& part, const TileTurn& turn, const HitTile& hits, const LightVisibility& lit);

} // namespace firsthit
