// raster_scratch.h - what the rasteriser needs, beside its result, while it makes a tile's items.
#pragma once

#include "base/buffer.h"
#include "base/tile_order.h"
#include "visibility/bin/eye_mesh.h"
#include "visibility/stored_depth.h"
#include "visibility/tile_items.h"

#include <array>
#include <cstdint>

namespace firsthit {

/// Triangles of the first batch of a tile, and of the largest ones (measured). A batch is set up
/// together.
inline constexpr int kFirstBatch = 8, kBatch = 32;

/// How a triangle of the batch is rasterised.
enum class Kernel : std::int32_t {
    none,  // not at all: it misses the tile
    tiny,  // it has at most 2x2 samples, which are decided during set-up
    small, // edges and depth in float, quad by quad
    large, // the same, after tests of whole blocks
    wide,  // depth in double, as it has too large an error in float (it is seen at a grazing angle)
    cutout,      // a cut-out: edges and depth in float, each sample that may be hit one by one
    wide_cutout, // the same with depth in double
    exact, // exactly, sample by sample: neither is certain (the eye is nearly in the triangle's
           // plane), or 1/t might overflow
};

/// The triangles that are rasterised next, as a structure of arrays. set_up_lanes computes its
/// second half from the first, for the kernels. Edges and depth are affine in the sample's offset
/// (x, y) from (origin_x, origin_y), which is a sample of the tile: e = c + gx x + gy y.
struct Batch {
    int count = 0;
    std::uint32_t triangle[kBatch];
    alignas(64) float corner[9][kBatch]; // x0 y0 z0 x1 ... in eye space
    alignas(64) std::int32_t x0[kBatch], y0[kBatch], x1[kBatch],
        y1[kBatch]; // box; x1, y1 are inside
    alignas(64) std::int32_t origin_x[kBatch], origin_y[kBatch];
    alignas(64) std::int32_t extent_x[kBatch], extent_y[kBatch]; // largest offsets of samples
    alignas(
        64) float nearest_w[kBatch]; // at least 1/t anywhere; infinity if it reaches behind the eye

    alignas(64) Kernel kernel[kBatch];
    alignas(64) float gx[3][kBatch], gy[3][kBatch], c[3][kBatch]; // edges: |e| <= 1, e > 0 inside
    alignas(64) float wx[kBatch], wy[kBatch], wc[kBatch];         // 1/t
    alignas(64) double wide_wx[kBatch], wide_wy[kBatch], wide_wc[kBatch];
    alignas(64) float tiny_w[4][kBatch]; // 1/t at (x0, y0), (x0 + 1, y0), ... where hit, else 0

    Corners corners(int i) const
    {
        return {glm::vec3(corner[0][i], corner[1][i], corner[2][i]),
            glm::vec3(corner[3][i], corner[4][i], corner[5][i]),
            glm::vec3(corner[6][i], corner[7][i], corner[8][i])};
    }
};

/// Remembers for pairs of triangles whether they lie in one plane, so that coplanar surfaces that
/// overlap are not compared by exact arithmetic at every sample.
struct CoplanarCache {
    struct Pair {
        std::uint32_t a = 0, b = 0;
        bool coplanar = false;
    };
    std::array<Pair, 64> pair{};
};

/// One worker's scratch memory. All of it is in the order of tiles (base/tile_order.h).
struct RasterScratch {
    Buffer<float> w; // (samples) 1/t of the items found so far, 0 where there is none
    /// (blocks) at most the least w of each block. Eight more: a register may be read from any
    /// block on.
    alignas(64) float block_w[(kMaxTile / kBlock) * (kMaxTile / kBlock) + 8];
    std::uint64_t stale[4]; // a bit for each block: block_w may be less than the block's least w
    float least_w = 0;      // at most the least w of all blocks
    /// tile_offset(x, y) = column_offset[x] + row_offset[y]
    alignas(64) std::int32_t column_offset[kMaxTile];
    alignas(64) std::int32_t row_offset[kMaxTile];

    Batch batch;
    CoplanarCache coplanar;

    /// Entries that are sorted at once, nearest first.
    static constexpr std::size_t kChunk = 4096;
    std::uint16_t chunk_order[kChunk]; // entry numbers in the chunk, sorted
    std::uint8_t chunk_depth[kChunk];  // class of depth of each entry
};

/// Prepares the scratch memory for tiles of size x size samples. Allocates only to grow.
void resize(RasterScratch& scratch, int size);

/// A tile that is being rasterised.
struct TileInWork {
    const EyeMesh& mesh; // in CornerSpace::eye
    TileItems& items;
    RasterScratch& scratch;
};

} // namespace firsthit
