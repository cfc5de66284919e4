// film.h - a picture: its colours and further named planes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit {

/// The planes that a film can have besides colour. Each value belongs to the ray through the centre
/// of the pixel, for any number of samples, and is never blended. "none" is the value of pixels
/// that see nothing.
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
    instance, // 1 x uint32: the instance that the triangle belongs to, of Scene::instances; none = 0xFFFFFFFF
    material, // 1 x uint32: of Scene::materials; none = 0xFFFFFFFF
    node,     // 1 x uint32: that the instance hangs on, of Scene::nodes; none = 0xFFFFFFFF
    tangent, // 4: interpolated, unit, world space, along growing texture coordinate u; the fourth is the
             // side of the bitangent (Mesh::tangent); none, or the scene has no tangents = 0
    metallic_roughness, // 2: metallic and roughness, textured, each 0 to 1; other models and none = 0
    emission,           // 3: light of its own, textured, linear; other models and none = 0
    motion,         // 2: pixels right and down from where the same point of the surface was seen in
                    // Settings::previous, to this pixel's centre; not seen from there and none = 0
    motion_visible, // 1: whether the point was in that picture and nothing was before it, 0 or 1
    normal_camera,  // 3: as normal, in the camera's frame (x right, y down, z forward); none = 0
    position_camera, // 3: in that frame, from the eye, world units: the third is the depth; none = 0
};

/// How many planes there are in Aov.
inline constexpr int kAovCount = 20;

/// The largest number of lights for which the plane `lit` can be made.
inline constexpr std::size_t kMaxLitLights = 64;

/// The name of a plane in files and on the command line: "item", "depth", ...
std::string_view aov_name(Aov aov);

/// The plane with a name: the inverse of aov_name.
/// throws  ArgumentError: unknown name; the message lists all names
Aov aov_from_name(std::string_view name);

/// The number of channels of a plane: 1 to 4. Returns 0 for `lit`, which has one channel for
/// each light of the world (see Plane::channels).
int aov_channels(Aov aov);

/// Whether a plane holds ids (uint32) instead of floats.
constexpr bool holds_ids(Aov aov)
{
    return aov == Aov::item || aov == Aov::instance || aov == Aov::material || aov == Aov::node;
}

/// (height, width, channels) float, row 0 at the top. Empty where it was not asked for.
struct Plane {
    int channels = 0;         // number of values in a pixel; 0 if the plane is empty
    std::vector<float> value; // height * width * channels

    /// Whether there are no values.
    bool empty() const { return value.empty(); }
};

/// A picture: colours in linear Rec.709, (height, width, 3), and the planes that were asked for.
struct Film {
    int width = 0;                       // pixels
    int height = 0;                      // pixels
    Plane color;                         // 3 channels, linear; empty where it was not asked for
    Plane alpha;                         // 1 channel, 0 to 1: see Settings::alpha; or empty
    std::array<Plane, kAovCount> aov;    // float planes, by Aov; see ids() for those of ids
    std::vector<std::uint32_t> item;     // (height, width), or empty
    std::vector<std::uint32_t> instance; // likewise
    std::vector<std::uint32_t> material; // likewise
    std::vector<std::uint32_t> node;     // likewise

    /// A plane of ids (holds_ids) by its name.
    std::vector<std::uint32_t>& ids(Aov a)
    {
        return a == Aov::instance   ? instance
               : a == Aov::material ? material
               : a == Aov::node     ? node
                                    : item;
    }
    /// The same, to read.
    const std::vector<std::uint32_t>& ids(Aov a) const { return const_cast<Film*>(this)->ids(a); }

    /// A plane of floats by its name. Those that hold ids stay empty: see ids().
    Plane& operator[](Aov a) { return aov[static_cast<std::size_t>(a)]; }
    /// The same for a const film.
    const Plane& operator[](Aov a) const { return aov[static_cast<std::size_t>(a)]; }
};

/// How light that is brighter than a picture can show is made darker.
enum class ToneMap {
    none,                // what is above 1 is shown as 1
    aces,                // S. Hill's fit of the Academy's RRT and ODT, of saturated contrast
    khronos_pbr_neutral, // Khronos PBR Neutral: keeps colours below 0.8 as they are, but for 0.04
};

/// How light becomes the numbers of a .png.
struct Tone {
    double exposure_ev = 0;      // light is multiplied by 2^this first, -100 to 100
    ToneMap map = ToneMap::none; // and then made to fit
};

/// Colours, linear, 3 values each, with a tone: 0 to 1 but for ToneMap::none. Values that are not finite
/// count as 0 where they are mapped.
/// source  Hill 2017 (github.com/TheRealMJP/BakingLab, ACES.hlsl); Khronos 2024, "Khronos PBR Neutral
///         Tone Mapper"
/// throws  ArgumentError: an exposure out of range
std::vector<float> toned(std::vector<float> color, const Tone& tone);

/// Writes the colours as .png (8-bit sRGB) or .exr (float R, G, B); the path's ending chooses, and
/// picture.h has more endings and choices. Each value of a .png is the nearest code. The file appears
/// whole or not at all: it is written under a temporary name in the same folder and renamed.
/// throws  FileError: it cannot be written
///         ArgumentError: another ending, or the film has no colours
void write_color(const Film& film, const std::string& path);

/// The same, with a tone for .png. Pictures in .exr stay linear, as they were rendered.
/// throws  as write_color; ArgumentError: an exposure out of range
void write_color(const Film& film, const std::string& path, const Tone& tone);

/// Writes one plane as .exr (ids as UINT, the others as FLOAT; channel names Z, N.X, P.X, lit.0,
/// ...) or .npy (uint32 (H, W) for ids, float32 (H, W) or (H, W, C)), by the file's ending. `depth` and
/// `distance` are also written as .png of 16 bits: millimetres where the scene's unit is the metre,
/// rounded, at least 1; 0 where nothing is seen, and 65535 for all that is farther.
/// returns  how many pixels of a .png are farther than 65.535, which its values cannot say
/// throws  as write_color; ArgumentError where the film lacks the plane or lit has too many lights
std::uint64_t write_aov(const Film& film, Aov aov, const std::string& path);

/// Checks, before a long computation, whether write_color accepts a path. Creates nothing.
/// throws  ArgumentError: another ending; FileError: the folder does not exist or is not writable
void check_color_path(const std::string& path);

/// The same for write_aov.
void check_aov_path(const std::string& path);

} // namespace firsthit
