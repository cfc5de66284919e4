// picture_window.h - the part of a picture of items that lies in and around one tile.
#pragma once

#include "visibility/tile_items.h"

#include <firsthit/scene.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>

namespace firsthit {

/// Reads a picture of items by coordinates (x, y) from a tile's first sample, to the right and
/// down. Outside the picture every item is kNoItem.
class PictureWindow {
  public:
    /// picture  (height, width) row 0 at the top
    /// x, y     the tile's first sample, in the picture
    PictureWindow(std::span<const std::uint32_t> picture, int width, int height, int x, int y)
        : picture_(picture),
          width_(width),
          height_(height),
          x_(x),
          y_(y)
    {
    }

    std::uint32_t at(int x, int y) const
    {
        const int px = x_ + x, py = y_ + y;
        if (px < 0 || py < 0 || px >= width_ || py >= height_) return kNoItem;
        return row(py)[px];
    }

    /// Copies `count` items of row y, from x on.
    void copy_row(int x, int y, int count, std::uint32_t* to) const
    {
        const int px = x_ + x, py = y_ + y;
        const bool has_row = py >= 0 && py < height_;
        const int first = has_row ? std::clamp(-px, 0, count) : count;
        const int last = has_row ? std::clamp(width_ - px, first, count) : count;
        std::fill(to, to + first, kNoItem);
        if (first < last)
            std::memcpy(to + first, row(py) + px + first, std::size_t(last - first) * sizeof(*to));
        std::fill(to + last, to + count, kNoItem);
    }

    /// Copies all items of the tile, in tile order.
    void copy(TileItems& tile) const
    {
        for (int y = 0; y < tile.size; ++y) {
            std::uint32_t* to = tile.item.data() + tile_offset(0, y, tile.size);
            for (int x = 0; x < tile.size; x += 4) {
                std::uint32_t* quad = to + tile_offset(x, 0, tile.size);
                if (y_ + y < height_ && x_ + x + 4 <= width_) [[likely]]
                    std::memcpy(quad, row(y_ + y) + x_ + x, 4 * sizeof(*quad));
                else
                    copy_row(x, y, 4, quad);
            }
        }
    }

    /// The samples inside the picture of the block whose first sample is (x, y), a bit each.
    std::uint64_t block_inside(int x, int y) const
    {
        const int columns = width_ - x_ - x, rows = height_ - y_ - y;
        if (columns >= kBlock && rows >= kBlock) [[likely]]
            return ~std::uint64_t(0);
        std::uint64_t inside = 0;
        for (int k = 0; k < kBlockSamples; ++k)
            if (block_x(k) < columns && block_y(k) < rows) inside |= std::uint64_t(1) << k;
        return inside;
    }

  private:
    const std::uint32_t* row(int y) const
    {
        return picture_.data() + std::size_t(y) * std::size_t(width_);
    }

    std::span<const std::uint32_t> picture_;
    int width_, height_;
    int x_, y_;
};

} // namespace firsthit
