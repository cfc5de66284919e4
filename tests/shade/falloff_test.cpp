// falloff_test.cpp - lights that fade with distance, by KHR_lights_punctual.
#include "shade/tile_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firsthit {
namespace {

/// A matt white wall at z = -10 that reflects 1 / pi of what it gets.
void make_matt_wall(TileScene& tile)
{
    tile.scene.ambient = {0, 0, 0};
    tile.add_material<MetallicRoughness>() = {.metallic = 0, .f0 = glm::vec3(0), .specular = 0};
    tile.add_wall(10);
}

/// Calls test(irradiance found, point) for samples of the tile.
template <class Test>
void for_samples(TileScene& tile, const Light& light, const Test& test)
{
    tile.world.lights = {light};
    tile.cast();
    ShadeMemory memory;
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    for (int y = 0; y < tile.hits.size; y += 2)
        for (int x = 0; x < tile.hits.size; x += 2)
            test(std::numbers::pi * double(at(memory.targets.color, x, y, tile.hits.size).r),
                tile.direction(x, y) * 10.0);
}

TEST(Falloff, PointLightOfOneCandelaGivesOneOverDistanceSquared)
{
    for (const double height : {0.5, 2.0, 8.0}) {
        TileScene tile;
        make_matt_wall(tile);
        Light light{.position = {1, 0.5, -10 + height}, .color = glm::vec3(700)};
        light.inverse_square = true;
        for_samples(tile, light, [&](double found, const glm::dvec3& point) {
            const glm::dvec3 d = light.position - point;
            const double distance2 = glm::dot(d, d), cosine = height / std::sqrt(distance2);
            const double expected = 700 * cosine / distance2;
            EXPECT_NEAR(found, expected, 1e-4 * expected);
        });
    }
}

TEST(Falloff, EndsAtTheRange)
{
    TileScene tile;
    make_matt_wall(tile);
    Light light{.position = {0, 0, -7}, .color = glm::vec3(50)};
    light.inverse_square = true;
    light.range = 4;
    int beyond = 0, within = 0;
    for_samples(tile, light, [&](double found, const glm::dvec3& point) {
        const glm::dvec3 d = light.position - point;
        const double distance = glm::length(d);
        const double window = std::max(std::min(1 - std::pow(distance / 4, 4), 1.0), 0.0);
        const double expected = 50 * (3 / distance) * window / (distance * distance);
        EXPECT_NEAR(found, expected, 1e-5 + 1e-4 * expected);
        (distance > 4 ? beyond : within) += 1;
        if (distance > 4.0001) {
            EXPECT_EQ(found, 0);
        }
    });
    EXPECT_GT(beyond, 0);
    EXPECT_GT(within, 0);
}

TEST(Falloff, SpotsFadeByTheSquareOfWhatIsLinearInTheCosine)
{
    for (const double inner : {0.0, 0.2, 0.3}) {
        TileScene tile;
        make_matt_wall(tile);
        Light light{.kind = Light::Kind::spot, .position = {0.5, 0, -4}, .direction = {0.1, 0, -1}};
        light.inner_rad = inner;
        light.outer_rad = 0.3;
        light.color = glm::vec3(200);
        light.inverse_square = true;
        int between = 0;
        for_samples(tile, light, [&](double found, const glm::dvec3& point) {
            const glm::dvec3 d = point - light.position;
            const double distance = glm::length(d);
            const double cosine = glm::dot(glm::normalize(light.direction), d / distance);
            const double scale = 1 / std::max(0.001, std::cos(inner) - std::cos(0.3));
            const double share = std::clamp(cosine * scale - std::cos(0.3) * scale, 0.0, 1.0);
            const double expected = 200 * (6 / distance) * share * share / (distance * distance);
            EXPECT_NEAR(found, expected, 2e-4 + 1e-3 * expected);
            between += share > 0 && share < 1;
        });
        EXPECT_EQ(between > 0, inner < 0.3);
    }
}

TEST(Falloff, DirectionalLightsAndOthersDoNotFade)
{
    TileScene tile;
    make_matt_wall(tile);
    Light sun{.kind = Light::Kind::directional, .direction = {0, 0, -2}, .color = glm::vec3(3)};
    sun.inverse_square = true;
    for_samples(tile, sun, [&](double found, const glm::dvec3&) { EXPECT_NEAR(found, 3, 1e-5); });
    Light lamp{.position = {0, 0, 990}, .color = glm::vec3(3)};
    for_samples(tile, lamp, [&](double found, const glm::dvec3&) { EXPECT_NEAR(found, 3, 1e-3); });
}

} // namespace
} // namespace firsthit
