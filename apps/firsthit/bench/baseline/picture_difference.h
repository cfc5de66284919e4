// picture_difference.h - how many pixels of two pictures are not the same.
#pragma once

#include "common/json.h"

#include <firsthit/film.h>

#include <cstdint>

namespace firsthit::cli::bench {

struct PictureDifference {
    std::uint64_t pixels = 0; // of each picture
    std::uint64_t items = 0;  // see another triangle, or none
    std::uint64_t colors =
        0; // are displayed in another colour: a channel of the 8-bit sRGB picture
           // differs by more than 1
};

/// Both have colours and items.
/// throws  ArgumentError: they are of different sizes, or lack either
PictureDifference difference(const Film& a, const Film& b);

/// {"pixels", "items", "colors"}
Json difference_json(const PictureDifference& difference);

} // namespace firsthit::cli::bench
