// join.h - puts pictures and planes together that were rendered in tiles.
#pragma once

#include <firsthit/view.h>

#include <span>
#include <string>

namespace firsthit {

/// A file that holds a rectangle of a picture, as View::region makes it.
struct PictureTile {
    std::string path; // .png, .exr or .npy
    Region region{};  // where it belongs; width and height are above 0 and those of the file
};

/// Writes the picture that tiles are parts of. Its values are those of the tiles, bit for bit, and its file is
/// the one that this library writes for the whole picture. It appears whole or not at all.
///
/// tiles   one or more, all of one kind: .png of 8 or 16 bits with the same channels, .exr with the same
///         channels and types, .npy with the same type and number of values in a pixel. Together they cover a
///         rectangle from (0, 0) on, each pixel once
/// output  has the ending of the tiles
/// throws  ArgumentError: a gap or an overlap (the message names the pixel and the files), another ending, no tile
///         FileError: a tile that cannot be read, has another size than its region, or another kind than the
///         first; the output cannot be written
/// limits  the whole picture is held in memory
void join_tiles(std::span<const PictureTile> tiles, const std::string& output);

} // namespace firsthit
