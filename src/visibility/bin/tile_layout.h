// tile_layout.h - the samples of a pencil, divided into tiles.
#pragma once

#include "base/buffer.h"
#include "exact/pencil.h"
#include "visibility/bin/block_bits.h"

#include <cstdint>

namespace firsthit {

/// Tiles are numbered row by row. Those at the right and at the bottom may reach beyond the
/// pencil's samples.
struct TileLayout {
    Pencil pencil;
    int tile_size = 64;           // samples on a side
    int tiles_x = 0;              // tiles in a row
    int tiles_y = 0;              // rows of tiles
    Buffer<std::uint8_t> tile_of; // (longer side) the column or row of tiles that a sample lies in

    /// Blocks of samples; null: all. Triangles that may hit samples of no such block may be left out.
    const BlockBits* wanted = nullptr;

    int tiles() const { return tiles_x * tiles_y; }

    /// The pencil's sample that is the first one of a tile.
    int first_x(int tile) const { return tile % tiles_x * tile_size; }
    int first_y(int tile) const { return tile / tiles_x * tile_size; }

    /// The rays of a tile's samples, in eye space.
    LatticeTile rays(int tile) const { return pencil.tile(first_x(tile), first_y(tile)); }
};

/// Divides the pencil's samples into tiles of tile_size x tile_size samples. At most 256 tiles in a
/// row and in a column. Allocates only to grow.
void lay_out(const Pencil& pencil, int tile_size, TileLayout& layout);

} // namespace firsthit
