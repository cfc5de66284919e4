// raster_tile.h - the item buffer of one tile.
#pragma once

#include "visibility/raster/item_tile.h"
#include "visibility/bin/view_memory.h"

namespace firsthit {

/// Prepares a worker's tile; allocates where it is larger than before.
void resize(ItemTile& tile, int size);

/// Which triangle does each sample of the tile see? Fills out.item and out.w for tile number `tile`
/// of the binned view. The item is the triangle that is_hit and compare_depth (exact/hit.h) name
/// over all triangles, ties to the lowest id; nothing else enters.
///
/// source  Weghorst, Hooper and Greenberg 1984, "Improved Computational Methods for Ray Tracing"
///         (item buffer); Robert and Schoepke 2006, section 3.1
void raster_tile(const ViewMemory& view, int tile, ItemTile& out);

} // namespace firsthit
