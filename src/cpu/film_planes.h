// film_planes.h - from tiles of samples to the planes of the film.
#pragma once

#include "cpu/copy_rows.h"
#include "cpu/frame_memory.h"

namespace firsthit {

/// Where a tile lies in the picture.
struct TilePlace {
    const TileLayout& view;
    Region part;   // the pixels that the view's pencil covers
    Region region; // the pixels that the film covers
    int samples;   // on a pixel's side
    int tile;
    /// Samples that have no colour of their own, a word for each block of the tile; empty: none.
    std::span<const std::uint64_t> holes = {};
};

/// The tile's pixels inside the picture.
PixelRect pixels_of(const TilePlace& place);

/// Points the targets that are asked for at memory for one tile, the others at null.
void resize(ShadeMemory& memory, int tile_size, bool color, std::span<const Aov> aovs);

/// Copies the tile to the film's planes that have a size; colour is the mean of a pixel's samples
/// that are no holes (of all where all are), summed in a fixed order. The other planes need samples
/// = 1.
void store_tile(const TilePlace& place, const HitTile& hits, const LightVisibility& lit,
    const ShadeTargets& shaded, Film& film);

/// What store_tile does where the tile has no item, and only colour is asked for, with one sample a
/// pixel.
void store_background(const TilePlace& place, const glm::vec3& background, Film& film);

/// Marks the tile's pixels whose samples are all holes: mask (height, width) of the film, 1 or 0.
void mark_holes(const TilePlace& place, int film_width, std::span<std::uint8_t> mask);

/// Samples with an item.
std::uint64_t count_hits(const HitTile& hits);

} // namespace firsthit
