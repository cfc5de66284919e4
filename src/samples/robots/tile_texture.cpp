// tile_texture.cpp - a tiled floor, made in code.
#include "samples/robots/tile_texture.h"

#include "base/srgb.h"
#include "samples/noise.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace firsthit {
namespace {

constexpr int kTextureSize = 512; // texels on a side
constexpr int kTiles = 8;         // on a side
constexpr int kTile = kTextureSize / kTiles;
constexpr int kGrout = 3; // texels between tiles

/// Linear colour of a texel.
glm::vec3 color_at(int x, int y)
{
    const int in_x = x % kTile;
    const int in_y = y % kTile;
    const glm::vec2 place = glm::vec2(x, y) / static_cast<float>(kTextureSize);
    const float clouds =
        0.6f * smooth_noise(place, {16, 16}, 1) + 0.3f * smooth_noise(place, {64, 64}, 2) +
        0.1f * noise_at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 3);
    const int edge = std::min({in_x, in_y, kTile - 1 - in_x, kTile - 1 - in_y});
    if (2 * edge < kGrout) return glm::vec3(0.16f, 0.15f, 0.14f) * (0.8f + 0.3f * clouds);

    // Every tile a little different, its rim worn darker; every other one of a warmer stone.
    const auto tile_x = static_cast<std::uint32_t>(x / kTile);
    const auto tile_y = static_cast<std::uint32_t>(y / kTile);
    const float own = 0.85f + 0.3f * noise_at(tile_x, tile_y, 4);
    const float rim = edge < 5 ? 0.86f + 0.028f * static_cast<float>(edge) : 1.0f;
    const bool warm = (tile_x + tile_y) % 2 == 0;
    const glm::vec3 stone = warm ? glm::vec3(0.50f, 0.44f, 0.36f) : glm::vec3(0.36f, 0.38f, 0.40f);
    return stone * own * rim * (0.75f + 0.4f * clouds);
}

} // namespace

Texture make_tiles()
{
    Picture picture{kTextureSize, kTextureSize, {}};
    picture.pixel.reserve(std::size_t(kTextureSize) * kTextureSize);
    const SrgbTable& table = srgb_table();
    for (int y = 0; y < kTextureSize; ++y)
        for (int x = 0; x < kTextureSize; ++x) {
            const glm::vec3 linear = color_at(x, y);
            picture.pixel.push_back(0xFF000000u | std::uint32_t(table.code(linear.b)) << 16 |
                                    std::uint32_t(table.code(linear.g)) << 8 |
                                    table.code(linear.r));
        }
    return Texture("tiles", picture);
}

} // namespace firsthit
