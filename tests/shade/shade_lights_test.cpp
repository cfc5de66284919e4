// shade_lights_test.cpp - the light of each kind of light source, with cones and light visibility.
#include "shade/tile_scene.h"

#include <gtest/gtest.h>

#include <limits>

namespace firsthit {
namespace {

/// A white wall at depth 10 without ambient light. Its middle is the tile's first sample.
struct Occluder : TileScene {
    ShadeMemory memory;
    alignas(64) float lit[4 * 64]; // of up to 4 lights

    Occluder() : TileScene(8)
    {
        hits.rays.x0 = hits.rays.y0 = 0;
        material().ambient = {0, 0, 0};
        material().diffuse = {1, 1, 1};
        add_wall();
        cast();
    }

    void set_lit(std::size_t light, float share)
    {
        for (std::size_t k = 0; k < 64; ++k) lit[64 * light + k] = share;
    }

    glm::vec3 color(const LightVisibility& light_visibility = {})
    {
        shade_tile(hits, world, light_visibility, memory.targets);
        return at(memory.targets.color, 0, 0, hits.size);
    }
};

Light spot_above(double angle_rad, double inner_rad, double outer_rad)
{
    // The light is at the eye, which looks along -z. Its axis misses the wall's middle by the
    // angle.
    return {.kind = Light::Kind::spot,
        .direction = {std::sin(angle_rad), 0, -std::cos(angle_rad)},
        .inner_rad = inner_rad,
        .outer_rad = outer_rad};
}

TEST(ShadeLights, DirectionalLightOnAPlaneCountsByItsCosine)
{
    Occluder wall;
    wall.world.lights = {{.kind = Light::Kind::directional,
        .position = {1e6, -3e9, 7},
        .direction = {0, 300 * std::sqrt(3.0), -300},
        .color = {1, 0.5f, 0}}};
    EXPECT_NEAR(wall.color().x, 0.5f, 1e-6f);
    EXPECT_NEAR(wall.color().y, 0.25f, 1e-6f);
    for (int k = 0; k < 64; ++k)
        EXPECT_EQ(wall.memory.targets.color[0][k], wall.color().x) << "the same everywhere";
    wall.world.lights[0].direction.z = 300;
    EXPECT_EQ(wall.color(), glm::vec3(0)) << "from behind";
}

TEST(ShadeLights, ASpotIsAPointLightInsideItsInnerCone)
{
    Occluder wall;
    wall.world.lights = {spot_above(0.3, 0.31, 0.8)};
    EXPECT_EQ(wall.color(), glm::vec3(1));
}

TEST(ShadeLights, ASpotHasNoLightOutsideItsOuterCone)
{
    Occluder wall;
    wall.world.lights = {spot_above(0.3, 0.1, 0.29)};
    EXPECT_EQ(wall.color(), glm::vec3(0));
    wall.world.lights = {spot_above(3.0, 0.1, 1.5)};
    EXPECT_EQ(wall.color(), glm::vec3(0)) << "shines away";
}

TEST(ShadeLights, ASpotFadesBetweenItsCones)
{
    Occluder wall;
    const double half = std::acos((std::cos(0.1) + std::cos(0.5)) / 2);
    wall.world.lights = {spot_above(half, 0.1, 0.5)};
    EXPECT_NEAR(wall.color().x, 0.5f, 1e-6f);
}

TEST(ShadeLights, EachLightCountsAsFarAsItIsLit)
{
    Occluder wall;
    wall.add_light({0, 0, 0}, {1, 0, 0});
    wall.add_light({0, 0, 0}, {0, 1, 0});
    wall.add_light({0, 0, 0}, {0, 0, 1});
    wall.set_lit(0, 1);
    wall.set_lit(1, 0);
    wall.set_lit(2, 0.25f);
    EXPECT_EQ(wall.color({wall.lit, 64}), glm::vec3(1, 0, 0.25f));
}

TEST(ShadeLights, SamplesAreLitOneByOne)
{
    Occluder wall;
    wall.add_light({0, 0, 0});
    for (int k = 0; k < 64; ++k) wall.lit[k] = k % 3 == 0 ? 1.0f : 0.0f;
    shade_tile(wall.hits, wall.world, {wall.lit, 64}, wall.memory.targets);
    for (int k = 0; k < 64; ++k) EXPECT_EQ(wall.memory.targets.color[0][k] > 0, k % 3 == 0) << k;
}

TEST(ShadeLights, LitEverywhereIsAsWithoutShadows)
{
    Occluder wall, plain;
    for (Occluder* each : {&wall, &plain}) {
        each->material().specular = glm::vec3(0.5f);
        each->material().shininess = 3.5f;
        each->world.lights = {{.position = {3, 4, -1}}, spot_above(0.2, 0, 0.7),
            {.kind = Light::Kind::directional, .direction = {1, 2, -3}}};
    }
    for (std::size_t light = 0; light < 3; ++light) wall.set_lit(light, 1);
    wall.color({wall.lit, 64});
    plain.color();
    for (int k = 0; k < 64; ++k)
        EXPECT_EQ(wall.memory.targets.color[0][k], plain.memory.targets.color[0][k]);
}

TEST(ShadeLights, SamplesWithoutAnItemAreNotAskedForTheirLight)
{
    Occluder wall;
    wall.add_light({0, 0, 0});
    wall.runs = {{0, 0, 0, 0xF0F0F0F0F0F0F0F0u}};
    wall.point_at_arrays();
    for (int k = 0; k < 64; ++k) wall.lit[k] = k & 4 ? 1 : std::numeric_limits<float>::quiet_NaN();
    shade_tile(wall.hits, wall.world, {wall.lit, 64}, wall.memory.targets);
    for (int k = 0; k < 64; ++k) {
        const float red = wall.memory.targets.color[0][k];
        if (k & 4)
            EXPECT_GT(red, 0.8f);
        else
            EXPECT_EQ(red, wall.scene.background.r);
    }
}

TEST(ShadeLights, SpotsAddWhateverTheirNumber)
{
    Occluder wall;
    for (int i = 0; i < 40; ++i) wall.world.lights.push_back(spot_above(0.2, i % 2 ? 0.3 : 0, 0.9));
    const float one_pair = [] {
        Occluder two;
        two.world.lights = {spot_above(0.2, 0, 0.9), spot_above(0.2, 0.3, 0.9)};
        return two.color().x;
    }();
    EXPECT_NEAR(wall.color().x, 20 * one_pair, 1e-4f);
}

} // namespace
} // namespace firsthit
