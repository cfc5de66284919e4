// tile_layout.h - the samples of a pencil, cut into tiles.
#pragma once

#include "base/buffer.h"
#include "exact/pencil.h"

#include <cstdint>

namespace firsthit {

/// Tiles are numbered row by row; those at the right and at the bottom may reach beyond the samples.
struct TileLayout {
    Pencil pencil;
    int tile_size = 64; // samples on a side
    int tiles_x = 0;
    int tiles_y = 0;
    Buffer<std::uint8_t> tile_of; // sample -> tile number on one axis

    int tiles() const { return tiles_x * tiles_y; }
};

/// Cuts the pencil's samples. Allocates only where they are more than before.
void lay_out(const Pencil& pencil, int tile_size, TileLayout& layout);

} // namespace firsthit
