// picture.h - pictures as files: formats, transparency, dithering, and what stands behind the scene.
#pragma once

#include <firsthit/film.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace firsthit {

/// How a picture is written.
struct PictureOptions {
    Tone tone{};          // of all but .exr
    bool dither = true;   // 8-bit colours are dithered: see write_picture
    glm::ivec2 origin{0}; // column and row of the film's first pixel in the whole picture, by whose
                          // pixels the pattern of dithering goes: 0 and above
    int quality = 95;     // of .jpg and .webp, 1 to 100; 100 makes .webp without loss
    std::string format{}; // an ending of picture_endings() that counts in the place of the path's
};

/// The endings that write_picture takes: ".png", ".exr", and ".jpg", ".jpeg" and ".webp" where their libraries
/// were there when the library was built.
std::vector<std::string> picture_endings();

/// Writes the colours of a film by the path's ending, or to standard output where the path is "-" and
/// options.format says how. .png, .jpg and .webp have 8-bit sRGB colours, .exr has float linear ones.
///
/// A film with `alpha` becomes a picture with transparency, whose colours must have been made before a black
/// background (Scene::background): .png and .webp have straight alpha, that is, colours that do not hold
/// the background's; .exr has channels R, G, B multiplied by A, as is usual there; .jpg has no transparency.
///
/// Dithering rounds up or down by an ordered 8 x 8 pattern of the pixel's place, the same for all channels, so
/// that the mean light of a flat region is right to a 64th of a code's step. It is the same in every run, and a
/// value that is a code's own, such as 0 and 1, stays what it is. Alpha is not dithered.
///
/// throws  FileError: it cannot be written, or the format cannot hold as many pixels
///         ArgumentError: an ending that is not accepted (the message lists all that are), a quality out of
///         range, a film without colours, .jpg of a film with alpha, "-" without a format
void write_picture(const Film& film, const std::string& path, const PictureOptions& options = {});

/// Checks, before a long computation, whether write_picture accepts a path and options. Creates nothing.
/// throws  as write_picture
void check_picture_path(const std::string& path, const PictureOptions& options = {});

/// Encodes pixels as a .jpg in memory, for those who send pictures instead of writing them.
/// rgba     (height, width, 4) sRGB, top row first; alpha is not looked at
/// quality  1 to 100
/// returns  the bytes of the file
/// throws   ArgumentError: another number of values, a side that is not from 1 to 65500 pixels, a quality out of range,
///          a library that was built without libjpeg
std::string encode_jpeg(std::span<const std::uint8_t> rgba, int width, int height, int quality);

/// As write_aov, in a format by an ending such as ".npy", also to standard output where the path is "-".
/// An empty format is the path's ending.
std::uint64_t write_plane(
    const Film& film, Aov aov, const std::string& path, const std::string& format);

/// Checks, before a long computation, whether write_plane accepts these.
/// throws  ArgumentError: another ending, .png for a plane that is no distance; FileError: the folder
void check_plane_path(Aov aov, const std::string& path, const std::string& format);

/// A background whose colour goes from the picture's top to its bottom.
struct Gradient {
    glm::vec3 top{0};    // linear, 0 or above
    glm::vec3 bottom{0}; // linear, 0 or above
};

/// Lays a film with `alpha` before a background, and empties its alpha. The colours must have been made before
/// a black background. The film's first row is row `first_row` of a picture of `rows` rows, whose first
/// row's upper border has the colour `top`.
/// throws  ArgumentError: a film without colours or alpha, colours that are negative or not finite
void lay_over(Film& film, const Gradient& gradient, int first_row, int rows);

} // namespace firsthit
