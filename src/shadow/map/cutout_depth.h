// cutout_depth.h - rasterises the cut-outs of one tile of a shadow map.
#pragma once

#include "exact/pencil.h"
#include "shadow/map/raster_depth.h"
#include "visibility/bin/bins.h"
#include "visibility/bin/eye_mesh.h"

#include <span>

namespace firsthit {

/// Adds the cut-outs among the entries to a tile that raster_depth has made, where they are there
/// (exact/cutouts.h).
///
/// mesh      in CornerSpace::flat
/// parallel  Pencil::parallel
/// rays      of the tile's samples
/// entries   of the tile
void raster_cutout_depth(const EyeMesh& mesh, bool parallel, const LatticeTile& rays,
    std::span<const TileEntry> entries, DepthTile& tile);

} // namespace firsthit
