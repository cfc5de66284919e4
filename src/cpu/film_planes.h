// film_planes.h - stores tiles of samples in the planes of the film.
#pragma once

#include "cpu/copy_rows.h"
#include "cpu/frame_memory.h"

namespace firsthit {

struct PixelMarks;

/// Where a tile lies in the picture.
struct TilePlace {
    const TileLayout& layout;
    Region part;   // the picture's pixels that the layout's pencil covers
    Region region; // the picture's pixels that the film covers
    int samples;   // samples on a side of a pixel
    int tile;      // its number in the layout
    /// (blocks) a bit for each sample that has no colour of its own; empty if all samples have one.
    std::span<const std::uint64_t> holes = {};
    const PixelMarks* only = nullptr; // the only pixels whose colour is stored, of N x N samples
};

/// The tile's pixels that lie inside the part.
PixelRect pixels_of(const TilePlace& place);

/// Points the targets of the wanted planes to memory for one tile, and the other targets to null.
/// Allocates only to grow.
void resize(ShadeMemory& memory, int tile_size, bool color, std::span<const Aov> aovs);

/// Stores the tile in all planes of the film that have a size. The colour of a pixel is the mean of
/// its samples that are no holes, or of all its samples if all are holes, summed in a fixed order.
/// Planes other than colour need one sample a pixel.
void store_tile(const TilePlace& place, const HitTile& hits, const LightVisibility& lit,
    const ShadeTargets& shaded, Film& film);

/// Does what store_tile does for a tile without any item, if colour is the only plane and a pixel
/// has one sample.
void store_background(const TilePlace& place, const glm::vec3& background, Film& film);

/// Sets the mask of the tile's pixels: 1 if all samples of a pixel are holes, else 0.
///
/// mask  (height, film_width) of the film
void mark_holes(const TilePlace& place, int film_width, std::span<std::uint8_t> mask);

/// The number of samples that have an item.
std::uint64_t count_hits(const HitTile& hits);

} // namespace firsthit
