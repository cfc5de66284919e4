// write_pixels.h - writes what is on a screen as a file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace firsthit::cli::view {

/// Writes pixels (height, width, 4) sRGB, top row first, as .png without alpha. throws  FileError
void write_pixels(
    const std::vector<std::uint8_t>& rgba, int width, int height, const std::string& path);

} // namespace firsthit::cli::view
