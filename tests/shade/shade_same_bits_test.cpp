// shade_same_bits_test.cpp - every instruction set gives the same bits as shading sample by sample.
#include "instruction_sets.h"
#include "shade/noise_texture.h"
#include "shade/plain_shade.h"
#include "shade/tile_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>

namespace firsthit {
namespace {

/// color_only  no other planes are made, so the code skips what only they need
void expect_same_bits(
    const TileScene& tile, const char* what, const LightVisibility& lit, bool color_only)
{
    ShadeMemory plain;
    plain_shade(tile.hits, tile.world, lit, plain.targets);
    for_instruction_sets([&] {
        ShadeMemory memory;
        ShadeTargets targets = memory.targets;
        if (color_only) {
            targets = {};
            std::copy_n(memory.targets.color, 3, targets.color);
        }
        shade_tile(tile.hits, tile.world, lit, targets);
        int different = 0;
        for (int plane = 0; plane < (color_only ? 3 : ShadeMemory::kPlanes); ++plane)
            for (int k = 0; k < tile.hits.size * tile.hits.size; ++k) {
                const float a = plain.plane(plane)[k];
                const float b = memory.plane(plane)[k];
                if (std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b)) continue;
                if (++different < 5)
                    ADD_FAILURE() << what << ": plane " << plane << ", sample " << k << ": plain "
                                  << a << ", kernel " << b;
            }
        EXPECT_EQ(different, 0);
    });
}

void expect_same_bits(const TileScene& tile, const char* what, const LightVisibility& lit = {})
{
    expect_same_bits(tile, what, lit, false);
    expect_same_bits(tile, what, lit, true);
}

glm::vec3 random_point(std::mt19937& random, float size)
{
    std::uniform_real_distribution<float> number(-size, size);
    const float x = number(random), y = number(random), z = number(random);
    return {x, y, z};
}

/// Random triangles with random normals, texture coordinates and materials.
void fill_with_soup(TileScene& tile, std::mt19937& random)
{
    tile.scene.textures.push_back(noise_texture(37, 64));
    tile.scene.textures.push_back(noise_texture(1, 1));
    const float shininess[] = {0, 1, 5, 10.5f, 64, 300, 0.25f};
    for (int k = 0; k < 60; ++k) {
        if (k % 4 == 0) {
            Phong& material = tile.add_material();
            material.ambient = glm::abs(random_point(random, 1));
            material.diffuse = glm::abs(random_point(random, 1));
            if (k % 3) material.specular = glm::abs(random_point(random, 1));
            material.shininess = shininess[random() % 7];
            material.texture = static_cast<std::int32_t>(random() % 3) - 1;
            if (k % 20 == 8)
                tile.scene.materials.back().model =
                    Unlit{.color = material.diffuse, .texture = {.texture = material.texture}};
        }
        const glm::vec3 middle = random_point(random, 6) - glm::vec3(0, 0, 12);
        const auto uv = [&] { return glm::vec2(random_point(random, 3)); };
        tile.add_triangle(middle + random_point(random, 4), middle + random_point(random, 4),
            middle + random_point(random, 4), uv(), uv(), uv());
        for (std::size_t corner = 0; corner < 3; ++corner)
            tile.world.normal[tile.world.normal.size() - 1 - corner] =
                glm::normalize(random_point(random, 1));
    }
    for (int k = 0; k < 3; ++k)
        tile.add_light(glm::dvec3(random_point(random, 20)), glm::abs(random_point(random, 1)));
}

/// Gives every other material maps of all kinds, and the scene all that they can ask for.
void add_maps(TileScene& tile, std::mt19937& random)
{
    Scene& scene = tile.scene;
    for (int k = 0; k < 6; ++k) {
        const int side = k % 2 ? 32 : 19; // several look at the same places of their textures
        scene.textures.push_back(noise_texture(side, side));
        scene.textures.back().set_sampler({.wrap_u = Wrap(k / 2), .wrap_v = Wrap((k + 1) / 2 % 3)});
    }
    scene.textures[2].set_sampler({.nearest = true});
    const auto map = [&] {
        TextureRef made{.texture = int(random() % 9) - 1, .uv_set = int(random() % 2)};
        if (random() % 2)
            for (int c = 0; c < 3; ++c) made.transform[c] = glm::vec2(random_point(random, 2));
        return made;
    };
    for (std::size_t m = 0; m < scene.materials.size(); m += 2) {
        if (m % 4 == 0) {
            scene.materials[m].model = Unlit{.color = random_point(random, 1), .texture = map()};
            continue;
        }
        const glm::vec3 share = glm::abs(random_point(random, 1));
        scene.materials[m].model =
            MetallicRoughness{.base_color = glm::abs(random_point(random, 1)),
                .metallic = share.x,
                .roughness = share.y,
                .emission = glm::abs(random_point(random, 0.5f)),
                .f0 = glm::abs(random_point(random, 1)),
                .specular = share.z,
                .normal_scale = 0.5f + share.x,
                .occlusion_strength = share.y,
                .base_color_texture = map(),
                .metallic_roughness_texture = map(),
                .normal_texture = map(),
                .occlusion_texture = map(),
                .emission_texture = map(),
                .specular_texture = map()};
    }
    for (std::size_t v = 0; v < scene.vertices; ++v) {
        scene.uv1.push_back(glm::vec2(random_point(random, 2)));
        scene.color.emplace_back(glm::abs(random_point(random, 1)), 1.0f);
        tile.world.tangent.emplace_back(
            glm::normalize(random_point(random, 1)), v / 3 % 2 ? 1.0f : -1.0f);
    }
    for (Light& light : tile.world.lights) {
        light.inverse_square = random() % 2;
        light.range = double(random() % 3) * 10;
        light.color *= 100.0f;
    }
}

Environment random_environment(std::mt19937& random, bool background)
{
    std::vector<glm::vec3> light;
    for (int k = 0; k < 40 * 20; ++k) light.push_back(glm::abs(random_point(random, 2)));
    Environment environment;
    environment.map = std::make_shared<EnvironmentMap>("random", 40, 20, light);
    environment.rotation_rad = random_point(random, 3).x;
    environment.strength = std::abs(random_point(random, 2).x);
    environment.background = background;
    return environment;
}

TEST(ShadeSameBits, OfMaterialsWithMaps)
{
    for (unsigned seed = 1; seed <= 6; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        TileScene tile(32, seed % 2 ? 20.0f : 60.0f);
        fill_with_soup(tile, random);
        for (int k = 0; k < 3; ++k) {
            Light light{.kind = Light::Kind::spot, .position = glm::dvec3(random_point(random, 5))};
            light.direction = {0, 0, -1};
            light.outer_rad = 0.5 + 0.3 * k;
            tile.world.lights.push_back(light);
        }
        add_maps(tile, random);
        if (seed % 2 == 0) tile.scene.environment = random_environment(random, seed == 4);
        if (seed == 5) tile.scene.uv1.clear();
        if (seed == 6) tile.scene.uv.clear();
        tile.cast();
        ASSERT_GT(tile.runs.size(), 30u);
        expect_same_bits(tile, "maps");
        alignas(64) static float lit[6 * 32 * 32];
        for (float& share : lit) share = std::max(0.0f, random_point(random, 1).x);
        std::fill_n(lit, 640, 0.0f);
        expect_same_bits(tile, "maps, in shadow", {lit, 32 * 32});
    }
}

TEST(ShadeSameBits, OfRandomTriangles)
{
    for (unsigned seed = 1; seed <= 8; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        TileScene tile(32);
        fill_with_soup(tile, random);
        tile.cast();
        ASSERT_GT(tile.runs.size(), 50u);
        expect_same_bits(tile, "soup");
    }
}

TEST(ShadeSameBits, OfTexturedTrianglesSeenInBlockAfterBlock)
{
    for (unsigned seed = 1; seed <= 2; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        TileScene tile(64, 40.0f);
        fill_with_soup(tile, random);
        fill_with_soup(tile, random);
        tile.cast();
        // More runs than are prepared together, with fewer different triangles.
        ASSERT_GT(tile.runs.size(), 200u);
        expect_same_bits(tile, "soup");
    }
}

TEST(ShadeSameBits, OfLightsOfEveryKindPartlyInShadow)
{
    for (unsigned seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        TileScene tile(32);
        fill_with_soup(tile, random);
        std::uniform_real_distribution<double> number(0, 1);
        while (tile.world.lights.size() < 24) { // more than ShadeLights keeps
            Light light{.kind = Light::Kind(tile.world.lights.size() % 3),
                .position = glm::dvec3(random_point(random, 20)) / 3.0,
                .direction = random_point(random, 1),
                .color = random_point(random, 1)};
            light.outer_rad = 1.5 * number(random);
            light.inner_rad = seed % 2 ? light.outer_rad : light.outer_rad * number(random);
            tile.world.lights.push_back(light);
        }
        tile.cast();
        // Blocks in shadow, lit blocks, registers with both; also negative zeros and colours.
        alignas(64) static float lit[24 * 32 * 32];
        for (std::size_t k = 0; k < std::size(lit); ++k) {
            const std::size_t group = k / 16 * 2654435761u >> 7 & 3;
            lit[k] = group == 0   ? 0.0f
                     : group == 1 ? 1.0f
                                  : std::max(0.0f, random_point(random, 1).x);
        }
        expect_same_bits(tile, "no shadows");
        expect_same_bits(tile, "shadows", {lit, 32 * 32});
    }
}

/// A mesh of triangles about as large as samples, whose normals point to any side and have any
/// length.
void fill_with_dust(TileScene& tile, std::mt19937& random, float side)
{
    const auto corner = [&](float x, float y) {
        return glm::vec3(x, y, -10) + random_point(random, side / 4);
    };
    for (float y = -4; y < 4; y += side)
        for (float x = -4; x < 4; x += side) {
            tile.add_triangle(corner(x, y), corner(x + side, y), corner(x + side, y + side));
            tile.add_triangle(corner(x, y), corner(x + side, y + side), corner(x, y + side));
        }
    for (glm::vec3& normal : tile.world.normal) {
        const unsigned kind = random() % 8;
        normal = kind == 0 ? glm::vec3(0) : kind == 1 ? -normal : random_point(random, 1);
    }
    tile.material().specular = glm::vec3(0.5f);
    tile.material().shininess = 9;
    tile.add_light({3, 5, 2});
    tile.add_light({-30, 5, -10}, {0.5f, 0.25f, 0});
}

TEST(ShadeSameBits, OfTrianglesAsSmallAsSamples)
{
    for (const float side : {0.2f, 0.4f, 0.6f, 1.0f, 1.5f}) {
        SCOPED_TRACE(side);
        std::mt19937 random(unsigned(side * 10));
        TileScene tile(16);
        fill_with_dust(tile, random, side);
        tile.cast();
        expect_same_bits(tile, "dust");
        alignas(64) float lit[2 * 16 * 16];
        for (float& share : lit) share = random() % 3 == 0 ? 1.0f : 0.0f;
        std::fill_n(lit, 64, 0.0f);
        std::fill_n(lit + 16 * 16, 64, 0.0f);
        expect_same_bits(tile, "dust, in shadow", {lit, 16 * 16});
    }
}

TEST(ShadeSameBits, OfTexturedTrianglesAsSmallAsSamples)
{
    std::mt19937 random(3);
    TileScene tile(64, 80.0f);
    tile.scene.textures.push_back(noise_texture(37, 64));
    tile.add_material().texture = 0;
    fill_with_dust(tile, random, 0.3f);
    for (glm::vec2& uv : tile.scene.uv) uv = glm::vec2(random_point(random, 3));
    tile.cast();
    ASSERT_GT(tile.runs.size(), 400u);
    expect_same_bits(tile, "dust");
}

TEST(ShadeSameBits, OfTheLastVertexOfItsArrays)
{
    // A corner is loaded as 16 bytes, but the last one of the array has only 12.
    std::mt19937 random(3);
    TileScene tile(16);
    fill_with_dust(tile, random, 0.5f);
    tile.cast();
    const std::size_t last = tile.item[100];
    std::vector<glm::vec3> position, normal;
    position.reserve(tile.world.position.size());
    normal.reserve(tile.world.normal.size());
    for (std::size_t triangle = 0; triangle <= last; ++triangle)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            position.push_back(tile.world.position[3 * triangle + corner]);
            normal.push_back(tile.world.normal[3 * triangle + corner]);
        }
    position.shrink_to_fit();
    normal.shrink_to_fit();
    tile.world.position = std::move(position);
    tile.world.normal = std::move(normal);
    tile.scene.index.resize(last + 1);
    tile.scene.owner.resize(last + 1);
    tile.scene.uv.resize(3 * (last + 1));
    tile.scene.vertices = 3 * (last + 1);
    tile.cast();
    expect_same_bits(tile, "last");
}

TEST(ShadeSameBits, OfAWorldWithoutNormals)
{
    std::mt19937 random(5);
    TileScene tile(16);
    fill_with_dust(tile, random, 0.5f);
    tile.cast();
    tile.world.normal.clear();
    expect_same_bits(tile, "no normals");
}

TEST(ShadeSameBits, OfLightThatOverflowsFloat)
{
    // Where no light arrives nothing is added, not even 0 * infinity = NaN.
    TileScene tile(16);
    tile.material().diffuse = glm::vec3(1e30f);
    tile.material().ambient = glm::vec3(-0.0f);
    tile.add_wall();
    tile.add_light({0, 0, 0}, glm::vec3(1e30f));
    tile.cast();
    alignas(64) float lit[16 * 16];
    for (int k = 0; k < 16 * 16; ++k) lit[k] = k < 128 ? 0.0f : k % 5 == 0 ? 1.0f : 0.0f;
    expect_same_bits(tile, "too much", {lit, 16 * 16});
}

TEST(ShadeSameBits, OfTexturesAtTheEdgesOfFloat)
{
    std::mt19937 random(1);
    for (const float repeats : {0.0f, 1e-30f, 1.0f, -1e7f, 1e9f, -1e20f, 1e30f, 1e38f}) {
        SCOPED_TRACE(repeats);
        TileScene tile(16);
        tile.scene.textures.push_back(noise_texture(64, 16));
        tile.material().texture = 0;
        tile.add_square({-20, -5, -1}, {40, 0, 0}, {0, 6, -50}, repeats);
        tile.cast();
        expect_same_bits(tile, "repeats");
    }
}

TEST(ShadeSameBits, OfLightsInThePlaneAndAtThePoint)
{
    TileScene tile(16);
    tile.material().specular = glm::vec3(1);
    tile.material().shininess = 2.5f;
    tile.add_wall();
    tile.add_light({0.25, 0.25, -10});
    tile.add_light({1e18, 0, 0});
    tile.cast();
    expect_same_bits(tile, "lights");
}

} // namespace
} // namespace firsthit
