// raster_depth.h - the depth of one tile of a shadow map.
//
// The item buffer's rasteriser names the triangle at each sample and decides what float leaves
// open. A map needs neither: coverage is right to a millionth of a texel (of triangles that became
// fragments, to a ten-thousandth), and of two depths that float cannot tell apart either will do.
#pragma once

#include "base/buffer.h"
#include "base/tile_order.h"
#include "visibility/bin/view_memory.h"

#include <cstdint>

namespace firsthit {

/// One worker's tile.
struct DepthTile {
    static constexpr int kBatch = 64; // triangles that are set up together

    int size = 0;    // texels on a side
    Buffer<float> w; // 1/t in tile order; 0 = nothing

    alignas(64) std::int32_t column_offset[kMaxTile]; // tile_offset(x, y) = column + row
    alignas(64) std::int32_t row_offset[kMaxTile];

    // The batch, structure of arrays. e = c + gx x + gy y, x and y from the tile's first sample.
    int count = 0;
    alignas(64) float corner[9][kBatch]; // x0 y0 z0 x1 ..., see CornerSpace
    alignas(64) std::int32_t x0[kBatch], y0[kBatch], x1[kBatch], y1[kBatch]; // samples, inclusive
    alignas(64) float gx[3][kBatch], gy[3][kBatch], c[3][kBatch];            // edges, inside >= 0
    alignas(64) float wx[kBatch], wy[kBatch], wc[kBatch];                    // 1/t
    alignas(
        64) std::int32_t tiny[kBatch];   // not 0: the box has at most 2x2 texels, decided in set-up
    alignas(64) float tiny_w[4][kBatch]; // at its corners: 1/t where covered, else 0
    alignas(64) float least_w[kBatch], greatest_w[kBatch]; // of the corners
};

/// Prepares a worker's tile; allocates where it is larger than before.
void resize(DepthTile& tile, int size);

/// Fills out.w for tile number `tile` of the binned view, whose corners are flat: the greatest 1/t of
/// the triangles that cover the sample. The same bits on every instruction set, whatever the order
/// of triangles.
///
/// limits   triangles seen at grazing angles may err by as much as their own extent in depth, and
///          reach as far beyond their edges as said above
/// source   Williams 1978, "Casting Curved Shadows on Curved Surfaces"
void raster_depth(const ViewMemory& view, int tile, DepthTile& out);

} // namespace firsthit
