// block_bits.h - a bit for each block of 8x8 samples of a pencil.
#pragma once

#include "base/buffer.h"
#include "base/tile_order.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace firsthit {

/// Blocks of a pencil's samples, counted from its first sample.
struct BlockBits {
    int columns = 0, rows = 0;  // of blocks
    std::size_t words = 0;      // of a row
    Buffer<std::uint64_t> word; // (rows, words)

    /// A rectangle of blocks; x1 and y1 are inside.
    struct Box {
        int x0, y0, x1, y1;
    };

    /// Sets the size, in samples, and clears all bits.
    void clear(int width, int height)
    {
        columns = (width + kBlock - 1) / kBlock;
        rows = (height + kBlock - 1) / kBlock;
        words = std::size_t(columns + 63) / 64;
        word.resize(words * std::size_t(rows));
        std::fill_n(word.data(), word.size(), std::uint64_t(0));
    }

    void set(int x, int y)
    {
        word[std::size_t(y) * words + std::size_t(x) / 64] |= std::uint64_t(1) << x % 64;
    }

    /// Whether any bit of a box is set. Parts of the box outside do not count.
    bool any(const Box& box) const
    {
        const int x0 = std::max(box.x0, 0), x1 = std::min(box.x1, columns - 1);
        const int y0 = std::max(box.y0, 0), y1 = std::min(box.y1, rows - 1);
        if (x0 > x1) return false;
        const std::uint64_t from = ~std::uint64_t(0) << x0 % 64,
                            to = ~std::uint64_t(0) >> (63 - x1 % 64);
        for (int y = y0; y <= y1; ++y) {
            for (int k = x0 / 64; k <= x1 / 64; ++k) {
                std::uint64_t bits = word[std::size_t(y) * words + std::size_t(k)];
                if (k == x0 / 64) bits &= from;
                if (k == x1 / 64) bits &= to;
                if (bits) return true;
            }
        }
        return false;
    }
};

} // namespace firsthit
