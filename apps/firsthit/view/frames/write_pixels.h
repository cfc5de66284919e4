// write_pixels.h - encodes what is on a screen, and writes it as a file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace firsthit::cli::view {

/// Pixels (height, width, 4) sRGB, top row first, as the bytes of a .png without alpha.
/// quick   in a fraction of the time, and larger
/// throws  Error
std::string encode_png(
    const std::vector<std::uint8_t>& rgba, int width, int height, bool quick = false);

/// Writes the bytes of encode_png. throws  FileError
void write_pixels(
    const std::vector<std::uint8_t>& rgba, int width, int height, const std::string& path);

} // namespace firsthit::cli::view
