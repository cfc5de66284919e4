// noise_texture.h - a texture of noise, on which reading a wrong texel shows.
#pragma once

#include <firsthit/texture.h>

#include <algorithm>
#include <random>
#include <vector>

namespace firsthit {

/// Each level has different noise, so that reading a wrong level shows.
inline Texture noise_texture(int width, int height, unsigned seed = 1)
{
    std::mt19937 random(seed);
    std::vector<Picture> levels;
    for (;; width = std::max(1, width / 2), height = std::max(1, height / 2)) {
        Picture level{width, height, {}};
        for (int k = 0; k < width * height; ++k)
            level.pixel.push_back(static_cast<std::uint32_t>(random()));
        levels.push_back(level);
        if (width == 1 && height == 1) return Texture("noise", levels);
    }
}

} // namespace firsthit
