// tile_items.h - which triangle each sample of a tile sees.
#pragma once

#include "base/buffer.h"
#include "base/tile_order.h"
#include "exact/hit.h"
#include "exact/pencil.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace firsthit {

/// How often floats could not decide while the items of a tile were found.
struct TileCounts {
    std::uint64_t uncertain = 0; // whether a ray hits a triangle
    std::uint64_t ambiguous = 0; // which of two triangles is nearer
    Effort effort;               // what exact arithmetic took to decide
};

/// The items of one tile: the result of the rasteriser or of the repair of items, and all that
/// later stages see of it.
struct TileItems {
    int size = 0;               // samples on a side: a multiple of kBlock, at most kMaxTile
    LatticeTile rays;           // the rays of the tile's samples, in eye space
    Buffer<std::uint32_t> item; // (size * size) triangle ids in tile order (base/tile_order.h),
                                // kNoItem where no triangle is seen
    TileCounts counts;
    /// (blocks) a bit for each sample whose item is asked for; empty: all are. The rasteriser gives the
    /// others kNoItem, whatever they see.
    std::span<const std::uint64_t> wanted;

    int blocks_x() const { return size / kBlock; }
    int blocks() const { return blocks_x() * blocks_x(); }

    /// The rays of the samples of block number `block`.
    LatticeTile block_rays(int block) const
    {
        return rays.from(block % blocks_x() * kBlock, block / blocks_x() * kBlock);
    }
};

/// Prepares the items of tiles of size x size samples; what they hold is undefined afterwards.
/// Allocates only to grow.
inline void resize(TileItems& items, int size)
{
    items.size = size;
    items.item.resize(std::size_t(size) * std::size_t(size));
}

} // namespace firsthit
