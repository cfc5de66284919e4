// tile_order.h - the memory layout of a tile's samples.
//
// A tile is a square of blocks of 8x8 samples, stored row by row. A block is 64 consecutive
// samples: four quads of 4x4 samples, row by row. A quad is 16 consecutive samples, row by row. So
// one SIMD register, which is 4, 8 or 16 consecutive samples, covers 4x1, 4x2 or 4x4 samples of the
// picture, and every 4 consecutive samples lie in one row of the picture.
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

inline constexpr int kBlock = 8;         // samples on a side of a block
inline constexpr int kBlockSamples = 64; // samples in a block
inline constexpr int kMaxTile = 128;     // most samples on a side of a tile

/// Offset in a block of the sample in column x and row y, both below 8.
constexpr int block_offset(int x, int y)
{
    return ((y >> 2) << 5) | ((x >> 2) << 4) | ((y & 3) << 2) | (x & 3);
}

/// Column and row of a sample in its block: the inverse of block_offset.
constexpr int block_x(int offset)
{
    return ((offset >> 4) & 1) * 4 + (offset & 3);
}
constexpr int block_y(int offset)
{
    return (offset >> 5) * 4 + ((offset >> 2) & 3);
}

/// Offset in a tile of `tile_size` samples on a side of the sample in column x and row y.
constexpr int tile_offset(int x, int y, int tile_size)
{
    const int block = (y / kBlock) * (tile_size / kBlock) + x / kBlock;
    return block * kBlockSamples + block_offset(x % kBlock, y % kBlock);
}

} // namespace firsthit
