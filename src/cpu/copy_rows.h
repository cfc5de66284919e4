// copy_rows.h - copies planes of a tile, which are in tile order, to rows of pixels of the film.
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>

namespace firsthit {

/// The pixels of a tile that lie inside the film.
struct PixelRect {
    int film_x, film_y; // the first pixel, in the film
    int width, height;  // in pixels
};

/// The rows of one plane of the film.
struct FilmRows {
    float* value; // (height, width, channels), aligned to 4 bytes
    int width;    // pixels in a row
    /// Whether rows that are aligned to 16 bytes are written past the caches. This is faster if the
    /// plane is larger than the caches: it would only displace what the next tile needs.
    bool stream;
};

/// Copies the pixels of the rectangle. The floats are copied bit by bit, whatever they mean.
///
/// tile_size  pixels on a side of the tile; the rectangle begins at the tile's first pixel
/// from       1 to 3 planes of the tile, one for each channel, in tile order (base/tile_order.h);
///            each is aligned to 64 bytes
void copy_rows(
    const PixelRect& rect, int tile_size, std::span<const float* const> from, const FilmRows& to);

/// Gives all pixels of the rectangle the same colour, in a plane with 3 channels.
void fill_rows(const PixelRect& rect, const glm::vec3& color, const FilmRows& to);

} // namespace firsthit
