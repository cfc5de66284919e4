// raster_tile.h - rasterises the item buffer of one tile.
#pragma once

#include "visibility/raster/item_tile.h"
#include "visibility/bin/view_memory.h"

namespace firsthit {

/// Prepares a worker's tile. Allocates only to grow.
void resize(ItemTile& tile, int size);

/// Finds the triangle that each sample of the tile sees: fills out.item and out.w for tile number
/// `tile` of the binned view. The item is exact: of all triangles that is_hit (exact/hit.h)
/// accepts, the first one by compare_depth, and of equal ones the one with the lowest id.
///
/// source  Weghorst, Hooper and Greenberg 1984, "Improved Computational Methods for Ray Tracing"
///         (item buffer); Robert and Schoepke 2006, section 3.1
void raster_tile(const ViewMemory& view, int tile, ItemTile& out);

} // namespace firsthit
