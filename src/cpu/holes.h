// holes.h - the samples that have no colour of their own, and what becomes of them.
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"
#include "hits/lattice.h"
#include "visibility/raster/item_tile.h"

#include <firsthit/film.h>

#include <cstdint>
#include <span>

namespace firsthit {

/// The holes of some tiles, and of the picture. A tile's are a word for each block, as ItemSource
/// fills them.
struct HoleMemory {
    Buffer<std::uint64_t> sample; // (tiles, blocks)
    Buffer<std::uint8_t> pixel;   // (height, width) of the film, 1 or 0
    std::size_t blocks = 0;       // of a tile

    std::span<std::uint64_t> of(std::size_t tile)
    {
        return sample.span().subspan(tile * blocks, blocks);
    }
};

/// Prepares the tiles; allocates where there are more or larger ones than before.
void resize(HoleMemory& memory, int tile_size, std::size_t tiles);

std::uint64_t count_holes(std::span<const std::uint64_t> holes);

/// Leaves the tile the items of the lattice, and makes all other samples holes. Returns how many of
/// the lattice's were holes before.
///
/// x, y    of the picture's pixel that the tile's first sample is
/// source  Robert and Schoepke 2006, section 4.1 (interleaved rendering)
std::uint64_t keep_lattice(
    const Lattice& lattice, int x, int y, ItemTile& items, std::span<std::uint64_t> holes);

/// Gives the film's holes the colours around them (film/fill_holes.h). Returns how many got one.
std::uint64_t interpolate_holes(const HoleMemory& memory, Tasks& tasks, Film& film);

} // namespace firsthit
