// picture_files.h - one function for each file format a film is written in.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace firsthit {

/// A plane as the formats take it: (height, width, channels), row 0 at the top, `value` or `item`.
struct PlaneView {
    int width = 0;
    int height = 0;
    int channels = 1;
    std::span<const float> value{};
    std::span<const std::uint32_t> item{}; // set instead of value; channels = 1
};

/// 8-bit sRGB from 3 channels of linear light.
/// throws  FileError, as all of these
void write_png(const PlaneView& color, const std::string& path);

/// Floats as FLOAT, items as UINT, one name for each channel.
void write_exr(
    const PlaneView& plane, const std::vector<std::string>& channel_names, const std::string& path);

/// NumPy format 1.0, little endian, C order: (height, width) for one channel, else (height, width,
/// channels).
void write_npy(const PlaneView& plane, const std::string& path);

} // namespace firsthit
