// film.h - named planes of a picture.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit {

/// What a film can hold beside the colour. All are of the ray through the pixel's centre, never
/// blended, whatever the number of samples.
enum class Aov {
    item,             // 1 x uint32: triangle id, none = 0xFFFFFFFF
    depth,            // 1: along the view axis, world units, none = +inf
    distance,         // 1: from the eye, world units, none = +inf
    uv,               // 2: texture coordinates, none = 0
    normal,           // 3: interpolated, unit, world space, towards the eye; none = 0
    geometric_normal, // 3: of the triangle's plane, unit, world space, towards the eye; none = 0
    position,         // 3: world space, none = 0
    albedo,           // 3: diffuse colour times texture, linear; none = 0
    barycentric,      // 2: u, v, weights of corners 1 and 2 (Embree's convention); none = 0
    lit, // one for each light: the share of it that arrives, 0 (in shadow) to 1; none = 0
};

/// How many planes there are in Aov.
inline constexpr int kAovCount = 10;

/// The plane `lit` is made of at most so many lights.
inline constexpr std::size_t kMaxLitLights = 64;

/// The name that files and the command line use: "item", "depth", ...
std::string_view aov_name(Aov aov);

/// The plane of a name.
/// throws  ArgumentError that lists the names
Aov aov_from_name(std::string_view name);

/// 1, 2 or 3; 0 for `lit`, which has as many as the world has lights (Plane::channels says it)
int aov_channels(Aov aov);

/// (height, width, channels) float, row 0 at the top. Empty where it was not asked for.
struct Plane {
    int channels = 0;         // values of a pixel; 0 where the plane is empty
    std::vector<float> value; // height * width * channels

    /// Whether there are no values.
    bool empty() const { return value.empty(); }
};

/// A picture: colour in linear Rec.709 (height, width, 3), and the planes asked for.
struct Film {
    int width = 0;                    // pixels
    int height = 0;                   // pixels
    Plane color;                      // 3 channels, linear; empty where it was not asked for
    std::array<Plane, kAovCount> aov; // float planes, by Aov; Aov::item is in `item`
    std::vector<std::uint32_t> item;  // (height, width), or empty

    /// A plane by its name. That of Aov::item stays empty: see `item`.
    Plane& operator[](Aov a) { return aov[static_cast<std::size_t>(a)]; }
    /// The same, to read.
    const Plane& operator[](Aov a) const { return aov[static_cast<std::size_t>(a)]; }
};

/// Writes the colour as 8-bit sRGB .png, or as float .exr (R, G, B), by the file's ending.
/// The file appears whole or not at all: it is written to a temporary name beside it and renamed.
/// throws  FileError (cannot be written), ArgumentError (another ending)
void write_color(const Film& film, const std::string& path);

/// Writes one plane as .exr (item as UINT, the others as FLOAT; channel names Z, N.X, P.X, lit.0,
/// ...) or .npy (uint32 (H, W) for item, float32 (H, W) or (H, W, C)), by the file's ending.
/// throws  as write_color; ArgumentError where the film lacks the plane or lit has too many lights
void write_aov(const Film& film, Aov aov, const std::string& path);

/// Throws what write_color would throw for the path alone: another ending, a folder that is missing
/// or may not be written. For asking before a long computation; nothing is created.
void check_color_path(const std::string& path);

/// The same of write_aov.
void check_aov_path(const std::string& path);

} // namespace firsthit
