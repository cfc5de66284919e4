// texture.h - a picture wrapped around triangles, in the form that shading samples.
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

/// 8 bits a channel, sRGB, as files have them.
struct Picture {
    int width = 0;                    // pixels
    int height = 0;                   // pixels
    std::vector<std::uint32_t> pixel; // height * width, top row first; RGBA, red in the lowest byte
};

/// Red, green, blue and alpha, times -32768: linear light from 0 to -32768, which is 1. What lies
/// between two neighbouring dark sRGB codes has nine steps or more.
using Texel = std::array<std::int16_t, 4>;
static_assert(sizeof(Texel) == 8);

/// A picture and its smaller copies, repeated outside [0, 1]. (0, 0) is the bottom left corner.
/// Takes 8 bytes a texel, and a third of that for smaller levels.
class Texture {
  public:
    static constexpr int kMaxSide = 16384;     // texels
    static constexpr int kMaxTexels = 1 << 26; // of the largest level
    static constexpr int kMaxLevels = 16; // one more than such a texture has: a register of them

    /// Has no level, and is white.
    Texture() = default;

    /// levels  the picture alone, whose smaller copies down to 1 x 1 are then averaged in linear
    ///         light (alpha as it is); or several levels, each half as wide and high as the one
    ///         before, rounded down, at least 1
    /// throws  ArgumentError: no level, one of another size, with too few or too many pixels, or
    ///         larger than kMaxSide or kMaxTexels
    Texture(std::string name, std::span<const Picture> levels);
    /// A picture alone.
    Texture(std::string name, const Picture& picture) : Texture(std::move(name), {&picture, 1}) {}

    /// As files and messages have it.
    const std::string& name() const { return name_; }
    /// Changes the name alone.
    void rename(std::string name) { name_ = std::move(name); }

    /// How many there are; 0 where it is white.
    int levels() const { return texel_.empty() ? 0 : levels_; }

    /// Of one level, texels.
    int width(int level = 0) const { return std::max(1, width_ >> level); }

    /// Of one level, texels.
    int height(int level = 0) const { return std::max(1, height_ >> level); }

    /// All levels, one after the other. Each is (height + 2, width + 2), top row first: around it
    /// is a border of one texel, where it begins anew, so that four neighbours always are two pairs.
    std::span<const Texel> texels() const { return texel_; }

    /// Where in texels() each level begins, at its border's corner.
    const std::array<std::int32_t, kMaxLevels>& first() const { return first_; }

    /// Linear colour and alpha of a texel, 0 to 1. Column and row are within the level.
    glm::vec4 color(int level, int column, int row) const;

    /// Mirrors all levels, so that the first row is the last.
    void turn_upside_down();

  private:
    std::string name_;
    int width_ = 0;
    int height_ = 0;
    int levels_ = 0;
    std::array<std::int32_t, kMaxLevels> first_{};
    std::vector<Texel> texel_;
};

} // namespace firsthit
