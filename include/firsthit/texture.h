// texture.h - textures and their mip levels, in the form that shading samples.
#pragma once

#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace firsthit {

/// A picture with 8 bits in each channel, as in files.
struct Picture {
    int width = 0;                    // pixels
    int height = 0;                   // pixels
    std::vector<std::uint32_t> pixel; // height * width, top row first; RGBA, red in the lowest byte
};

/// What the codes of a picture's red, green and blue mean. Alpha is always a share: code / 255.
enum class Encoding {
    srgb,   // light, by sRGB's curve
    linear, // data: code / 255
};

/// Red, green, blue and alpha, multiplied by -32768: linear light from 0 to -32768, which stands
/// for 1. Two neighbouring sRGB codes differ by at least nine steps, even the darkest.
using Texel = std::array<std::int16_t, 4>;
static_assert(sizeof(Texel) == 8);

/// How a texture goes on outside of [0, 1], along one axis.
enum class Wrap {
    repeat, // it begins anew
    mirror, // it runs back and forth
    clamp,  // its edge goes on
};

/// How a texture is sampled.
struct Sampler {
    Wrap wrap_u = Wrap::repeat; // along its rows
    Wrap wrap_v = Wrap::repeat; // along its columns
    bool nearest = false;       // the nearest texel of the largest level instead of a weighted mean
};

/// A picture and its smaller copies. (0, 0) is the bottom left corner.
/// Takes 8 bytes a texel, and a third of that for smaller levels.
class Texture {
  public:
    static constexpr int kMaxSide = 16384;     // largest width or height, texels
    static constexpr int kMaxTexels = 1 << 26; // most texels of level 0
    /// One more than the largest texture has; fills a SIMD register.
    static constexpr int kMaxLevels = 16;

    /// A texture without levels, which is white.
    Texture() = default;

    /// levels  one picture: smaller levels down to 1 x 1 are made by averaging in linear light
    ///         (alpha and data are averaged as they are). Or several pictures: all levels, each
    ///         half as wide and high as the one before, rounded down, at least 1
    /// throws  ArgumentError: no level; a level of the wrong size or with a wrong number of pixels;
    ///         or more than kMaxSide or kMaxTexels
    Texture(std::string name, std::span<const Picture> levels, Encoding encoding = Encoding::srgb);
    /// A texture of one picture, whose smaller levels are made.
    Texture(std::string name, const Picture& picture, Encoding encoding = Encoding::srgb)
        : Texture(std::move(name), {&picture, 1}, encoding)
    {
    }

    /// The name in the scene's file, used in messages.
    const std::string& name() const { return name_; }
    /// Changes the name.
    void rename(std::string name) { name_ = std::move(name); }

    /// How it is sampled.
    const Sampler& sampler() const { return sampler_; }
    /// Changes how it is sampled.
    void set_sampler(const Sampler& sampler);

    /// How many there are; 0 where it is white.
    int levels() const { return texel_.empty() ? 0 : levels_; }

    /// The width of a level, texels.
    int width(int level = 0) const { return std::max(1, width_ >> level); }

    /// The height of a level, texels.
    int height(int level = 0) const { return std::max(1, height_ >> level); }

    /// The texels of all levels, one level after the other. Each level is (height + 2, width + 2),
    /// top row first: it has a border of one texel as the sampler's wrap modes continue it, so that
    /// the four neighbours of a sample are always two pairs of adjacent texels.
    std::span<const Texel> texels() const { return texel_; }

    /// (levels) index in texels() of the first texel of each level, in the corner of its border.
    const std::array<std::int32_t, kMaxLevels>& first() const { return first_; }

    /// Linear colour and alpha of a texel, each 0 to 1. Column and row must be within the level.
    glm::vec4 color(int level, int column, int row) const;

    /// Flips all levels vertically.
    void turn_upside_down();

  private:
    void fill_borders();

    std::string name_;
    Sampler sampler_;
    int width_ = 0;
    int height_ = 0;
    int levels_ = 0;
    std::array<std::int32_t, kMaxLevels> first_{};
    std::vector<Texel> texel_;
};

} // namespace firsthit
