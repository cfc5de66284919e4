// picture.h - small pictures for the page: of a film's colours, of its items, parts of them enlarged.
#pragma once

#include <firsthit/film.h>
#include <firsthit/view.h>

#include <cstdint>
#include <vector>

namespace firsthit::cli::bench {

/// (height, width, 3) sRGB, row 0 at the top.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

/// The film's colours. throws  ArgumentError: it has none
Picture picture_of(const Film& film);

/// The film's items, each in a colour that its id decides; none is black.
/// throws  ArgumentError: it has none
Picture picture_of_items(const Film& film);

/// A part of a picture, every pixel as a square of `times` pixels. The part is cut to the picture.
Picture enlarged(const Picture& picture, const Region& part, int times);

/// As a PNG file. throws  FileError: libpng has no memory
std::vector<std::uint8_t> png(const Picture& picture);

} // namespace firsthit::cli::bench
