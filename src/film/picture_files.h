// picture_files.h - writes a plane of a film to a file: one function for each format.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace firsthit {

/// A plane to write: (height, width, channels) of `value` or `item`, row 0 at the top.
struct PlaneView {
    int width = 0;
    int height = 0;
    int channels = 1;
    std::span<const float> value{};
    std::span<const std::uint32_t> item{}; // used instead of `value` if not empty; channels = 1
};

/// Writes 3 channels of linear light as 8-bit sRGB.
/// throws  FileError, as do all functions of this file
void write_png(const PlaneView& color, const std::string& path);

/// Writes floats as FLOAT and items as UINT. One name for each channel.
void write_exr(
    const PlaneView& plane, const std::vector<std::string>& channel_names, const std::string& path);

/// Writes NumPy format 1.0, little endian, in C order. Shape (height, width) for one channel, else
/// (height, width, channels).
void write_npy(const PlaneView& plane, const std::string& path);

} // namespace firsthit
