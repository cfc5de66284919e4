// tile_layout.cpp - the samples of a pencil, divided into tiles.
#include "visibility/bin/tile_layout.h"

#include <algorithm>

namespace firsthit {

void lay_out(const Pencil& pencil, int tile_size, TileLayout& layout)
{
    layout.pencil = pencil;
    layout.wanted = nullptr;
    layout.tile_size = tile_size;
    layout.tiles_x = (pencil.width + tile_size - 1) / tile_size;
    layout.tiles_y = (pencil.height + tile_size - 1) / tile_size;
    const int longest = std::max(pencil.width, pencil.height);
    layout.tile_of.resize(std::size_t(longest));
    for (int k = 0; k < longest; ++k) layout.tile_of[std::size_t(k)] = std::uint8_t(k / tile_size);
}

} // namespace firsthit
