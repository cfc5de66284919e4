// raster_depth.h - rasterises the depth of one tile of a shadow map.
//
// Simpler than the item buffer's rasteriser, which has to find the triangle at each sample and
// decides exactly where float is uncertain. A map stores depth only: coverage may err by a
// millionth of a texel (a ten-thousandth for triangles that became fragments), and if float cannot
// order two depths, either may be stored.
#pragma once

#include "base/buffer.h"
#include "base/tile_order.h"
#include "exact/pencil.h"
#include "visibility/bin/bins.h"
#include "visibility/bin/eye_mesh.h"

#include <cstdint>

namespace firsthit {

/// One worker's tile.
struct DepthTile {
    static constexpr int kBatch = 64; // triangles that are set up together

    int size = 0;    // texels on a side
    Buffer<float> w; // 1/t in tile order; 0 = no triangle

    alignas(64) std::int32_t column_offset[kMaxTile]; // tile_offset(x, y) = column + row
    alignas(64) std::int32_t row_offset[kMaxTile];

    // The batch, a structure of arrays. Edge functions are e = c + gx x + gy y, where (x, y) is the
    // offset from the tile's first sample.
    int count = 0;
    alignas(64) float corner[9][kBatch]; // x0 y0 z0 x1 ..., see CornerSpace
    alignas(64) std::int32_t x0[kBatch], y0[kBatch], x1[kBatch], y1[kBatch]; // samples, inclusive
    alignas(64) float gx[3][kBatch], gy[3][kBatch], c[3][kBatch];            // edges, inside >= 0
    alignas(64) float wx[kBatch], wy[kBatch], wc[kBatch]; // 1/t = wc + wx x + wy y
    alignas(64) std::int32_t tiny[kBatch]; // not 0: at most 2x2 texels, rasterised during set-up
    alignas(64) float tiny_w[4][kBatch];   // at the box's corners: 1/t where covered, else 0
    alignas(64) float least_w[kBatch], greatest_w[kBatch]; // 1/t of the triangle's corners
};

/// Prepares a worker's tile. Allocates only to grow.
void resize(DepthTile& tile, int size);

/// Writes to out.w the greatest 1/t of the triangles that cover each sample of a tile. Leaves out
/// cut-outs (see cutout_depth.h). The same bits on
/// every instruction set and for every order of triangles.
///
/// mesh     in CornerSpace::flat
/// rays     of the tile's samples (TileLayout::rays)
/// bin      the tile's triangles (depth_bin_of)
/// out      resized to the tile's size
/// limits   the depth of triangles seen at grazing angles may err by as much as their own extent in
///          depth; coverage errs as described above
/// source   Williams 1978, "Casting Curved Shadows on Curved Surfaces"
void raster_depth(const EyeMesh& mesh, const LatticeTile& rays, const TileBin<DepthFragment>& bin,
    DepthTile& out);

} // namespace firsthit
