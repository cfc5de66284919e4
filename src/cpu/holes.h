// holes.h - the samples that have no colour of their own, and how they are filled.
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"
#include "visibility/tile_items.h"

#include <firsthit/film.h>

#include <cstdint>
#include <span>

namespace firsthit {

/// The holes of some tiles and of the film.
struct HoleMemory {
    Buffer<std::uint64_t> sample; // (tiles, blocks) a bit for each sample that is a hole
    Buffer<std::uint8_t> pixel;   // (height, width) of the film: 1 if a pixel is a hole, else 0
    std::size_t blocks = 0;       // in a tile

    /// (blocks) the holes of a tile.
    std::span<std::uint64_t> of(std::size_t tile)
    {
        return sample.span().subspan(tile * blocks, blocks);
    }
};

/// Prepares the holes of a number of tiles of tile_size x tile_size samples. Allocates only to
/// grow.
void resize(HoleMemory& memory, int tile_size, std::size_t tiles);

/// The number of samples that are holes.
///
/// holes  (blocks) of a tile
std::uint64_t count_holes(std::span<const std::uint64_t> holes);

/// Gives the holes of the film the colours around them (film/fill_holes.h). Returns how many pixels
/// were filled.
std::uint64_t interpolate_holes(const HoleMemory& memory, Tasks& tasks, Film& film);

} // namespace firsthit
