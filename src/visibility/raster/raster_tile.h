// raster_tile.h - rasterises the items of one tile.
#pragma once

#include "visibility/bin/bins.h"
#include "visibility/raster/raster_scratch.h"
#include "visibility/tile_items.h"

namespace firsthit {

/// Finds the triangle that each sample of a tile sees: fills out.item, out.rays and out.counts. The
/// items are exact: of all triangles that is_hit (exact/hit.h) accepts and that are there
/// (exact/cutouts.h), the first one by
/// compare_depth, and of equally near ones the one with the lowest id. Samples of the tile outside
/// the picture get items too; they are not defined.
///
/// mesh     in CornerSpace::eye
/// rays     of the tile's samples (TileLayout::rays)
/// bin      the tile's triangles (bin_of)
/// out      resized to the tile's size
/// scratch  resized to the tile's size; afterwards scratch.w holds 1/t of the items with a relative
///          error of at most kDepthError
/// source   Weghorst, Hooper and Greenberg 1984, "Improved Computational Methods for Ray Tracing"
///          (item buffer); Robert and Schoepke 2006, section 3.1
void raster_tile(const EyeMesh& mesh, const LatticeTile& rays, const TileBin<Fragment>& bin,
    TileItems& out, RasterScratch& scratch);

} // namespace firsthit
