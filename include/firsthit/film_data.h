// film_data.h - a film for other programs: 8-bit pixels, and all planes in one file.
#pragma once

#include <firsthit/film.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace firsthit {

/// The colours as 8-bit sRGB, (height, width, 3), row 0 at the top: the values of a .png. Dithered as
/// write_picture does it.
/// throws  ArgumentError: the film has no colours; an exposure out of range
std::vector<std::uint8_t> srgb_pixels(const Film& film, const Tone& tone = {}, bool dither = true);

/// Writes the colours and planes into one .exr file, with the channels
/// that write_color and write_aov give them: R, G, B, Z, N.X, instance, ... The file has a single part,
/// which programs that look for R, G, B (OpenCV) and those that sort channels into layers and passes by
/// the dots in their names (Blender) both read.
///
/// color   whether the colours are written; and a channel A, where the film has an alpha
/// aovs    each at most once
/// throws  as write_aov; ArgumentError: another ending than .exr, or nothing to write
void write_planes(const Film& film, bool color, std::span<const Aov> aovs, const std::string& path);

/// Checks, before a long computation, whether write_planes accepts a path. Creates nothing.
/// throws  ArgumentError: another ending; FileError: the folder does not exist or is not writable
void check_planes_path(const std::string& path);

} // namespace firsthit
