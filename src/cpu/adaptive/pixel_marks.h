// pixel_marks.h - the pixels of a picture that get N x N samples.
#pragma once

#include "base/buffer.h"
#include "base/tile_order.h"
#include "visibility/bin/tile_layout.h"

#include <firsthit/view.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firsthit {

/// Marks of the pixels of a region of a picture. Threads may mark pixels at the same time.
struct PixelMarks {
    Region region;              // of the picture
    int samples = 1;            // N: the samples that marked pixels get on a side
    Buffer<std::uint8_t> pixel; // (height, width) of the region: 1 where marked, else 0

    /// Begins without any marks.
    void clear(const Region& all, int n);

    /// Whether a pixel of the picture, which lies in the region, is marked.
    bool has(int x, int y) const
    {
        auto& mark =
            const_cast<std::uint8_t&>(pixel[index_of(x, y)]); // of which there is no atomic_ref
        return std::atomic_ref<std::uint8_t>(mark).load(std::memory_order_relaxed) != 0;
    }

    /// Marks it.
    void mark(int x, int y)
    {
        std::atomic_ref<std::uint8_t>(pixel[index_of(x, y)]).store(1, std::memory_order_relaxed);
    }

    /// The number of marked pixels in a part of the region.
    std::uint64_t count(const Region& part) const;

  private:
    std::size_t index_of(int x, int y) const
    {
        return std::size_t(y - region.y) * std::size_t(region.width) + std::size_t(x - region.x);
    }
};

/// A place among all samples of a picture, marks.samples times as wide and high as its pixels.
struct SamplePlace {
    int x, y;
};

/// Sets the bits of a tile's samples that lie in marked pixels.
///
/// first   the tile's first sample; samples outside the region are not wanted
/// wanted  (blocks) of a tile of `size` x `size` samples
void wanted_samples(
    const PixelMarks& marks, const SamplePlace& first, int size, std::span<std::uint64_t> wanted);

/// Finds the blocks and the tiles of a layout that hold samples of marked pixels.
///
/// first   the layout's first sample
/// blocks  set to the blocks
/// tiles   set to the numbers of the tiles, ascending
void wanted_blocks(const PixelMarks& marks, const SamplePlace& first, const TileLayout& layout,
    BlockBits& blocks, std::vector<std::uint32_t>& tiles);

} // namespace firsthit
