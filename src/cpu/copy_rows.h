// copy_rows.h - a tile's planes, in the order of its samples, to rows of pixels.
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>

namespace firsthit {

/// The tile's pixels inside the picture.
struct PixelRect {
    int film_x, film_y; // of the first pixel, in the film
    int width, height;  // pixels
};

/// Copies the rectangle's pixels, from the tile's first one on; their bits, whatever they mean.
///
/// film_width  pixels
/// tile_size   pixels on a side
/// from        a plane in tile order for each of 1 to 3 channels, aligned to 64 bytes
/// to          (height, film_width, channels), aligned to 4 bytes
/// stream      past the caches, rows that are aligned to 16 bytes: where the film is larger than
///             the caches, it would only push out of them what the next tile needs
void copy_rows(const PixelRect& rect, int film_width, int tile_size,
    std::span<const float* const> from, float* to, bool stream);

/// Gives all pixels of the rectangle the same colour; see copy_rows.
/// to  (height, film_width, 3)
void fill_rows(
    const PixelRect& rect, int film_width, const glm::vec3& color, float* to, bool stream);

} // namespace firsthit
