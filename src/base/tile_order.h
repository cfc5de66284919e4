// tile_order.h - how the samples of a tile are laid out in memory.
//
// A tile is a square of 8x8 blocks, row by row. A block is 64 consecutive samples: four 4x4
// quads, row by row; a quad is 16 consecutive samples, row by row. So 4, 8 or 16 consecutive
// samples (one SIMD register) are 4x1, 4x2 or 4x4 samples of the picture, and every run of 4 is a
// run of 4 in a row of the picture.
//
//     block            quad
//     +----+----+       0  1  2  3
//     | q0 | q1 |       4  5  6  7
//     +----+----+       8  9 10 11
//     | q2 | q3 |      12 13 14 15
//     +----+----+
#pragma once

#include <cstdint>

namespace firsthit {

inline constexpr int kBlock = 8;         // samples on a block's side
inline constexpr int kBlockSamples = 64; // in a block
inline constexpr int kMaxTile = 128;     // samples on a tile's side, at most

/// Offset inside a block of the sample x to the right and y down, both below 8.
constexpr int block_offset(int x, int y)
{
    return ((y >> 2) << 5) | ((x >> 2) << 4) | ((y & 3) << 2) | (x & 3);
}

/// Inverse of block_offset.
constexpr int block_x(int offset)
{
    return ((offset >> 4) & 1) * 4 + (offset & 3);
}
constexpr int block_y(int offset)
{
    return (offset >> 5) * 4 + ((offset >> 2) & 3);
}

/// Offset inside a tile that is `tile_size` samples wide.
constexpr int tile_offset(int x, int y, int tile_size)
{
    const int block = (y / kBlock) * (tile_size / kBlock) + x / kBlock;
    return block * kBlockSamples + block_offset(x % kBlock, y % kBlock);
}

} // namespace firsthit
