// painted_texture.h - a texture whose texels a function gives.
#pragma once

#include <firsthit/texture.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <string>

namespace firsthit {

/// A texture of 2^n texels on a side.
/// size      texels on a side
/// color_at  linear colour at a place in [0, 1) on both axes, (0, 0) bottom left; its texels are multiples of
///           1 / size, so that places times a power of two are exact
Texture paint_texture(std::string name, int size, glm::vec3 (*color_at)(const glm::vec2& place));

/// The same, of one colour that the function varies.
Texture paint_texture(std::string name, int size, const glm::vec3& color,
    glm::vec3 (*color_at)(const glm::vec2& place, const glm::vec3& color));

/// The part of x behind its point, for x of 0 and more.
inline float part_of(float x)
{
    return x - static_cast<float>(static_cast<int>(x));
}

/// 0 to 1, the same for the same whole number.
float chance(int number, std::uint32_t seed);

} // namespace firsthit
