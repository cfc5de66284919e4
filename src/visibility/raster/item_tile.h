// item_tile.h - the item buffer of one tile while it is made, and the batch of triangles in work.
#pragma once

#include "base/buffer.h"
#include "base/tile_order.h"
#include "exact/hit.h"
#include "exact/pencil.h"

#include <array>
#include <cstdint>

namespace firsthit {

/// Every stored w = 1/t is within kDepthError of the exact value, relatively. Two w that differ by
/// more than kDepthSlack (two errors and the comparison's own roundings take less than 3.3 * 2^-20)
/// are in the right order; closer ones are compared exactly.
inline constexpr float kDepthError = 0x1.8p-20f;
inline constexpr float kDepthSlack = 0x1p-18f;

/// The largest w that is stored, for depths below 2^-120: far from overflow, and two that are cut
/// down to it are compared exactly.
inline constexpr float kGreatestW = 0x1p120f;

/// Triangles that are set up together: at first in a tile, and at most (measured).
inline constexpr int kFirstBatch = 8, kBatch = 32;

/// How a triangle of the batch is rasterised.
enum class Kernel : std::int32_t {
    none,  // misses the tile
    tiny,  // at most 2x2 samples, decided during set-up
    small, // edges and depth in float, quad by quad
    large, // the same behind a test of whole blocks
    wide,  // depth in double: its float error is too large (seen at a grazing angle)
    exact, // neither is certain (the eye is nearly in the triangle's plane), or 1/t might overflow:
           // sample by sample
};

/// Structure of arrays, written by set_up, read by the kernels. Edges and depth are affine in the
/// sample's offset from (origin_x, origin_y), inside the tile: e = c + gx x + gy y.
struct Batch {
    int count = 0;
    std::uint32_t triangle[kBatch];
    alignas(64) float corner[9][kBatch]; // x0 y0 z0 x1 ... in eye space
    alignas(64) std::int32_t x0[kBatch], y0[kBatch], x1[kBatch], y1[kBatch]; // samples, inclusive
    alignas(64) std::int32_t origin_x[kBatch], origin_y[kBatch];
    alignas(64) std::int32_t extent_x[kBatch], extent_y[kBatch]; // largest offset that is evaluated
    alignas(64) float nearest_w[kBatch]; // 1 / the nearest corner's z, or infinity

    alignas(64) Kernel kernel[kBatch];
    alignas(64) float gx[3][kBatch], gy[3][kBatch], c[3][kBatch]; // edges, |e| <= 1, inside > 0
    alignas(64) float wx[kBatch], wy[kBatch], wc[kBatch];         // 1/t
    alignas(64) double wide_wx[kBatch], wide_wy[kBatch], wide_wc[kBatch];
    alignas(64) float tiny_w[4][kBatch]; // at (x0, y0), (x0+1, y0), ...: 1/t where hit, else 0

    Corners corners(int i) const
    {
        return {glm::vec3(corner[0][i], corner[1][i], corner[2][i]),
            glm::vec3(corner[3][i], corner[4][i], corner[5][i]),
            glm::vec3(corner[6][i], corner[7][i], corner[8][i])};
    }
};

/// Pairs of triangles known to lie in one plane, so that overlapping coplanar surfaces are not
/// compared by expansions at every sample.
struct CoplanarCache {
    struct Pair {
        std::uint32_t a = 0, b = 0;
        bool coplanar = false;
    };
    std::array<Pair, 64> pair{};
};

struct TileCounts {
    std::uint64_t uncertain = 0;
    std::uint64_t ambiguous = 0;
    Effort effort;
};

/// One worker's tile. w and item are in tile order (tile_order.h).
struct ItemTile {
    int size = 0; // samples on a side
    LatticeTile rays;
    Buffer<float> w;            // 1/t, 0 = nothing yet
    Buffer<std::uint32_t> item; // kNoItem = nothing yet
    /// Least w of each block, or less. A register may be read from any block on.
    alignas(64) float block_w[(kMaxTile / kBlock) * (kMaxTile / kBlock) + 8];
    std::uint64_t stale[4]; // blocks whose block_w may be too small, a bit each
    float least_w = 0;      // of all blocks, or less
    alignas(64) std::int32_t column_offset[kMaxTile]; // tile_offset(x, y) = column + row
    alignas(64) std::int32_t row_offset[kMaxTile];

    Batch batch;
    CoplanarCache coplanar;
    TileCounts counts;

    /// Entries sorted at once, nearest first.
    static constexpr std::size_t kChunk = 4096;
    std::uint16_t chunk_order[kChunk];
    std::uint8_t chunk_depth[kChunk];

    int blocks_x() const { return size / kBlock; }
    int blocks() const { return blocks_x() * blocks_x(); }

    /// Of a block's samples.
    LatticeTile block_rays(int block) const
    {
        return rays.from(block % blocks_x() * kBlock, block / blocks_x() * kBlock);
    }
};

} // namespace firsthit
