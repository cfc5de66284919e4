// unlit_test.cpp - unlit surfaces show their own colour, independently of lights and shadows.
#include "instruction_sets.h"
#include "shade/noise_texture.h"
#include "shade/tile_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>

namespace firsthit {
namespace {

/// An unlit wall with a texture, half of it behind a wall with Phong shading, and two lights.
void fill(TileScene& tile)
{
    tile.scene.textures.push_back(noise_texture(32, 32));
    tile.scene.ambient = {0.5f, 2, 3};
    tile.add_material<Unlit>() = {.color = {0.3f, 1.7f, 0.9f}, .texture = {.texture = 0}};
    tile.add_wall(10, 100, 40);
    tile.add_material();
    tile.add_square({0.3f, -50, -9}, {50, 0, 0}, {0, 100, 0});
    tile.add_light({3, 2, 1}, {1, 2, 3});
    Light spot;
    spot.kind = Light::Kind::spot;
    spot.direction = {0, 0, -1};
    tile.world.lights.push_back(spot);
    tile.cast();
}

TEST(Unlit, ColorIsTheAlbedoWhateverLightsAndShadowsAre)
{
    TileScene tile;
    fill(tile);
    const auto samples = std::size_t(tile.hits.size) * std::size_t(tile.hits.size);
    ShadeMemory shares; // of the two lights
    float* const aligned = shares.plane(0);
    for_instruction_sets([&] {
        ShadeMemory lighted, dark, colors, none;
        shade_tile(tile.hits, tile.world, {}, lighted.targets);
        for (std::size_t k = 0; k < 2 * samples; ++k) aligned[k] = k % 7 == 0 ? 0.3f : 0.0f;
        shade_tile(tile.hits, tile.world, {aligned, samples}, dark.targets);
        ShadeTargets only_color;
        std::copy_n(colors.targets.color, 3, only_color.color);
        shade_tile(tile.hits, tile.world, {aligned, samples}, only_color);
        World unlighted = tile.world;
        unlighted.lights.clear();
        shade_tile(tile.hits, unlighted, {}, none.targets);

        std::size_t unlit = 0, different = 0;
        for (std::size_t k = 0; k < samples; ++k) {
            if (tile.item[k] == kNoItem || tile.item[k] > 1) continue;
            ++unlit;
            for (const ShadeMemory* of : {&lighted, &dark, &colors, &none})
                for (int c = 0; c < 3; ++c)
                    different += std::bit_cast<std::uint32_t>(of->targets.color[c][k]) !=
                                 std::bit_cast<std::uint32_t>(lighted.targets.albedo[c][k]);
        }
        EXPECT_GT(unlit, samples / 4);
        EXPECT_LT(unlit, samples);
        EXPECT_EQ(different, 0u);
    });
}

TEST(Unlit, AlbedoIsColourTimesTexture)
{
    TileScene tile;
    tile.add_material<Unlit>().color = {0.25f, 1.5f, 0};
    tile.add_wall();
    tile.cast();
    ShadeMemory memory;
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    EXPECT_EQ(at(memory.targets.albedo, 3, 3, tile.hits.size), glm::vec3(0.25f, 1.5f, 0));
    EXPECT_EQ(at(memory.targets.color, 3, 3, tile.hits.size), glm::vec3(0.25f, 1.5f, 0));
    EXPECT_EQ(at(memory.targets.normal, 3, 3, tile.hits.size), glm::vec3(0, 0, 1));
}

} // namespace
} // namespace firsthit
