// picture_files.h - writes a plane of a film to a file: one function for each format.
#pragma once

#include <firsthit/film.h>

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

class PictureCodes; // picture_codes.h

/// Writes 8-bit sRGB, with or without alpha.
/// throws  FileError, as do all functions of this file
void write_png(const PictureCodes& picture, const std::string& path);

/// Writes one channel of 16 bits, (height, width), row 0 at the top.
void write_gray_png(
    std::span<const std::uint16_t> value, int width, int height, const std::string& path);

/// Whether this build writes JPEG.
bool can_write_jpeg();

/// quality  1 to 100; from 90 on colours are stored at full resolution
/// throws   FileError also for sides above 65500 pixels
void write_jpeg(const PictureCodes& picture, int quality, const std::string& path);

/// Whether this build writes WebP.
bool can_write_webp();

/// quality  1 to 100; 100 is without loss
/// throws   FileError also for sides above 16383 pixels
void write_webp(const PictureCodes& picture, int quality, const std::string& path);

/// Writes floats as FLOAT and items as UINT. One name for each channel.
void write_exr(
    const PlaneView& plane, const std::vector<std::string>& channel_names, const std::string& path);

/// Writes colours, (height, width, 3), as R, G, B and A: the channels of two arrays.
void write_rgba_exr(const PlaneView& color, std::span<const float> alpha, const std::string& path);
/// A plane and the name of each of its channels.
struct ExrPlane {
    PlaneView plane;
    std::vector<std::string> channel_names;
};

/// Writes planes of one size into a file of one part. No name twice.
void write_exr(std::span<const ExrPlane> planes, const std::string& path);

/// The names of a plane's channels in .exr files.
std::vector<std::string> channel_names(Aov aov, int channels);

/// The film's plane as it is written.
/// throws  ArgumentError where the film lacks it, or it has another shape or too many lights
PlaneView checked_plane(const Film& film, Aov aov);

/// The film's colours. throws  ArgumentError where there are none, or they have another shape
PlaneView checked_color(const Film& film);

/// Writes NumPy format 1.0, little endian, in C order. Shape (height, width) for one channel, else
/// (height, width, channels).
void write_npy(const PlaneView& plane, const std::string& path);

} // namespace firsthit
