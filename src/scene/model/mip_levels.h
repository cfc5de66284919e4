// mip_levels.h - the smaller copies of a picture.
#pragma once

#include <firsthit/texture.h>

#include <glm/vec4.hpp>

#include <vector>

namespace firsthit {

/// Linear red, green, blue, and alpha, 0 to 1; (height, width), top row first.
struct LinearPicture {
    int width = 0;
    int height = 0;
    std::vector<glm::vec4> pixel;
};

/// Half as wide and high, rounded down, at least 1; pixels that straddle two smaller ones count for
/// both by their share. Colours are averaged in linear light, alpha and data as they are. Must not be empty.
LinearPicture half_of(const Picture& picture, Encoding encoding);
LinearPicture half_of(const LinearPicture& picture);

} // namespace firsthit
