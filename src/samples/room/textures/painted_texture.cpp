// painted_texture.cpp - a texture whose texels a function gives.
#include "samples/room/textures/painted_texture.h"

#include "base/srgb.h"
#include "samples/noise.h"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace firsthit {
namespace {

template <class ColorAt>
Texture fill_texture(std::string name, int size, const ColorAt& color_at)
{
    Picture picture{size, size, {}};
    picture.pixel.reserve(std::size_t(size) * std::size_t(size));
    const SrgbTable& table = srgb_table();
    for (int y = size - 1; y >= 0; --y)
        for (int x = 0; x < size; ++x) {
            const glm::vec3 linear = color_at(glm::vec2(x, y) / static_cast<float>(size));
            picture.pixel.push_back(0xFF000000u | std::uint32_t(table.code(linear.b)) << 16 |
                                    std::uint32_t(table.code(linear.g)) << 8 |
                                    table.code(linear.r));
        }
    return Texture(std::move(name), picture);
}

} // namespace

Texture paint_texture(std::string name, int size, glm::vec3 (*color_at)(const glm::vec2& place))
{
    return fill_texture(std::move(name), size, color_at);
}

Texture paint_texture(std::string name, int size, const glm::vec3& color,
    glm::vec3 (*color_at)(const glm::vec2& place, const glm::vec3& color))
{
    return fill_texture(
        std::move(name), size, [&](const glm::vec2& place) { return color_at(place, color); });
}

float chance(int number, std::uint32_t seed)
{
    return noise_at(static_cast<std::uint32_t>(number), 0, seed);
}

} // namespace firsthit
