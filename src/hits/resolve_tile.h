// resolve_tile.h - where exactly does each sample's ray hit its item?
#pragma once

#include "base/buffer.h"
#include "hits/hit_tile.h"
#include "visibility/item_tile.h"
#include "visibility/view_memory.h"

namespace firsthit {

/// One worker's memory for resolve_tile.
struct HitMemory {
    Buffer<HitRun> run;
    Buffer<float> t, u, v;
};

/// Prepares the memory; allocates where the tile is larger than before.
void resize(HitMemory& memory, int tile_size);

/// Shoots one ray per sample at the triangle that the item buffer names. t, u and v come from one
/// division in double, rounded once: t is within one unit in the last place of the exact depth.
/// The result points into `items` and `memory`.
///
/// source  Robert and Schoepke 2006, section 4.1 (one lookup, one intersection test)
HitTile resolve_tile(const ViewMemory& view, const ItemTile& items, HitMemory& memory);

} // namespace firsthit
