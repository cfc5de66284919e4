// maps_test.cpp - textures of materials with maps: where they are sampled, how they go on, what they mean.
#include "instruction_sets.h"
#include "shade/noise_texture.h"
#include "shade/tile_scene.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace firsthit {
namespace {

/// The texel that stands for number k of n: the definition of each Wrap.
int texel_of(int k, int n, Wrap wrap)
{
    if (wrap == Wrap::clamp) return std::clamp(k, 0, n - 1);
    const int period = wrap == Wrap::mirror ? 2 * n : n;
    const int rest = ((k % period) + period) % period;
    return rest < n ? rest : 2 * n - 1 - rest;
}

/// The largest level at (u, v), which is of the scene: v counts from the bottom.
glm::dvec3 sample(const Texture& texture, double u, double v)
{
    const Sampler& sampler = texture.sampler();
    const auto color = [&](int column, int row) {
        return glm::dvec3(
            glm::vec3(texture.color(0, texel_of(column, texture.width(), sampler.wrap_u),
                texel_of(row, texture.height(), sampler.wrap_v))));
    };
    const double x = u * texture.width(), y = (1 - v) * texture.height();
    if (sampler.nearest) return color(int(std::floor(x)), int(std::floor(y)));
    const double x0 = std::floor(x - 0.5), y0 = std::floor(y - 0.5);
    const double right = x - 0.5 - x0, down = y - 0.5 - y0;
    const int column = int(x0), row = int(y0);
    return (color(column, row) * (1 - right) + color(column + 1, row) * right) * (1 - down) +
           (color(column, row + 1) * (1 - right) + color(column + 1, row + 1) * right) * down;
}

/// An unlit square that fills the view, with texture coordinates from -1.6 to 2.3, enlarged.
void make_wall(TileScene& tile, const TextureRef& map, const Sampler& sampler)
{
    tile.scene.textures.push_back(noise_texture(9, 7));
    tile.scene.textures.back().set_sampler(sampler);
    tile.add_material<Unlit>().texture = map;
    tile.add_square({-4.1f, -4.1f, -10}, {8.2f, 0, 0}, {0, 8.2f, 0});
    for (glm::vec2& uv : tile.scene.uv) uv = uv * 3.9f - 1.6f;
}

/// Compares all samples with the definition.
void expect_samples(TileScene& tile, const TextureRef& map)
{
    tile.cast();
    const Texture& texture = tile.scene.textures[0];
    for_instruction_sets([&] {
        ShadeMemory memory;
        shade_tile(tile.hits, tile.world, {}, memory.targets);
        int compared = 0;
        for (int y = 0; y < tile.hits.size; ++y)
            for (int x = 0; x < tile.hits.size; ++x) {
                const std::uint32_t item = tile.item[tile_offset(x, y, tile.hits.size)];
                const glm::dvec3 hit = tile.meet(item, x, y);
                const glm::uvec3 corner = tile.scene.index[item];
                const auto& uvs = map.uv_set == 0 ? tile.scene.uv : tile.scene.uv1;
                const glm::dvec2 uv = glm::dvec2(uvs[corner.x]) * (1 - hit.y - hit.z) +
                                      glm::dvec2(uvs[corner.y]) * hit.y +
                                      glm::dvec2(uvs[corner.z]) * hit.z;
                const glm::dvec2 at = glm::dmat3x2(map.transform) * glm::dvec3(uv, 1);
                if (texture.sampler().nearest) {
                    // Rounding decides next to a border between two texels.
                    const double from_border_x = std::abs(at.x * 9 - std::round(at.x * 9));
                    const double from_border_y = std::abs(at.y * 7 - std::round(at.y * 7));
                    if (std::min(from_border_x, from_border_y) < 1e-4) continue;
                }
                const glm::dvec3 expected = sample(texture, at.x, at.y);
                const glm::vec3 found = firsthit::at(memory.targets.color, x, y, tile.hits.size);
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(found[c], expected[c], 1e-3)
                        << x << " " << y << " uv " << at.x << " " << at.y;
                ++compared;
            }
        EXPECT_GT(compared, tile.hits.size * tile.hits.size / 2);
    });
}

TEST(Maps, GoOnAsTheirSamplersSay)
{
    for (int k = 0; k < 18; ++k) {
        SCOPED_TRACE(k);
        TileScene tile(64, 80.0f);
        const TextureRef map{.texture = 0};
        make_wall(tile, map, {Wrap(k % 3), Wrap(k / 3 % 3), k >= 9});
        expect_samples(tile, map);
    }
}

TEST(Maps, AreSampledWhereTheirTransformsSay)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> number(-0.7f, 0.7f);
    for (int k = 0; k < 20; ++k) {
        SCOPED_TRACE(k);
        TileScene tile(64, 80.0f);
        TextureRef map{.texture = 0, .uv_set = k % 2};
        for (int c = 0; c < 3; ++c) map.transform[c] = {number(random), number(random)};
        make_wall(tile, map, {Wrap(k % 3), Wrap(k / 3 % 3), k % 5 == 0});
        for (const glm::vec2& uv : tile.scene.uv)
            tile.scene.uv1.emplace_back(0.5f * uv.y, 0.25f - uv.x);
        expect_samples(tile, map);
    }
}

TEST(Maps, PhongsTextureObeysItsSamplerToo)
{
    for (int k = 1; k < 18; ++k) {
        SCOPED_TRACE(k);
        TileScene tile(64, 80.0f);
        const TextureRef map{.texture = 0};
        make_wall(tile, map, {Wrap(k % 3), Wrap(k / 3 % 3), k >= 9});
        tile.scene.materials.back().model =
            Phong{.ambient = glm::vec3(1), .diffuse = glm::vec3(0), .texture = 0};
        expect_samples(tile, map);
    }
}

/// A texture of one colour.
Texture plain(std::uint32_t rgba, Encoding encoding = Encoding::linear)
{
    return Texture("plain", Picture{1, 1, {rgba}}, encoding);
}

/// The colour in the middle of a wall of the material.
glm::vec3 color_of(TileScene& tile, const MetallicRoughness& model)
{
    tile.add_material<MetallicRoughness>() = model;
    tile.add_wall();
    tile.cast();
    ShadeMemory memory;
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    return at(memory.targets.color, 8, 8, tile.hits.size);
}

TEST(Maps, HaveChannelsForWhatTheyMean)
{
    const auto with = [](std::uint32_t rgba, Encoding encoding, const auto& change) {
        TileScene tile;
        tile.scene.textures.push_back(plain(rgba, encoding));
        tile.add_light({1, 2, -3}, glm::vec3(5));
        MetallicRoughness model{.base_color = {0.9f, 0.5f, 0.3f},
            .metallic = 0.8f,
            .roughness = 0.6f,
            .emission = {1, 2, 3},
            .f0 = glm::vec3(0.2f)};
        change(model, TextureRef{.texture = 0});
        return color_of(tile, model);
    };
    const auto without = [&](const auto& change) {
        return with(
            0xFFFFFFFF, Encoding::linear, [&](MetallicRoughness& m, TextureRef) { change(m); });
    };
    const auto expect_near = [](const glm::vec3& a, const glm::vec3& b) {
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 1e-3f);
    };
    constexpr std::uint32_t kTexel = 0x66804020; // red 32, green 64, blue 128, alpha 102
    const glm::vec3 linear = glm::vec3(32, 64, 128) / 255.0f;
    const glm::vec3 srgb(0.014444f, 0.051269f, 0.215861f);
    expect_near(with(kTexel, Encoding::srgb, [](auto& m, auto map) { m.base_color_texture = map; }),
        without([&](auto& m) { m.base_color *= srgb; }));
    expect_near(with(kTexel, Encoding::linear,
                    [](auto& m, auto map) { m.metallic_roughness_texture = map; }),
        without([&](auto& m) { m.roughness *= linear.g, m.metallic *= linear.b; }));
    expect_near(with(kTexel, Encoding::srgb, [](auto& m, auto map) { m.emission_texture = map; }),
        without([&](auto& m) { m.emission *= srgb; }));
    expect_near(with(kTexel, Encoding::srgb, [](auto& m, auto map) { m.specular_texture = map; }),
        without([&](auto& m) { m.f0 *= srgb, m.specular *= 0.4f; }));
    // Occlusion takes ambient light alone: 0.1 of the base colour.
    const glm::vec3 occluded = with(kTexel, Encoding::linear, [](auto& m, auto map) {
        m.occlusion_texture = map;
        m.occlusion_strength = 0.5f;
    });
    const glm::vec3 lost = 0.1f * glm::vec3(0.9f, 0.5f, 0.3f) * 0.5f * (1 - linear.r);
    expect_near(occluded, without([](auto&) {}) - lost);
}

TEST(Maps, ColoursOfVerticesMultiplyTheBaseColour)
{
    const glm::vec3 tint(0.25f, 0.5f, 0.75f);
    const auto albedo_of = [&](const Material::Model& model) {
        TileScene tile;
        tile.add_material();
        tile.scene.materials.back().model = model;
        tile.add_wall();
        for (std::size_t v = 0; v < tile.scene.vertices; ++v)
            tile.scene.color.emplace_back(tint, 0.5f);
        tile.cast();
        ShadeMemory memory;
        shade_tile(tile.hits, tile.world, {}, memory.targets);
        return at(memory.targets.albedo, 8, 8, tile.hits.size);
    };
    const glm::vec3 color(0.5f, 1, 0.25f);
    EXPECT_EQ(albedo_of(Phong{.diffuse = color}), color * tint);
    EXPECT_EQ(albedo_of(Unlit{.color = color}), color * tint);
    EXPECT_EQ(albedo_of(MetallicRoughness{.base_color = color}), color * tint);
}

TEST(Maps, NormalMapsTurnNormals)
{
    // (0.6, 0.0, 0.8) along tangent, bitangent and normal; then the same along the bitangent.
    for (const bool green : {false, true})
        for (const float w : {1.0f, -1.0f})
            for (const bool back : {false, true}) {
                TileScene tile;
                const std::uint32_t high = 204, middle = 128; // 0.6, 0
                tile.scene.textures.push_back(plain(
                    (green ? middle | high << 8 : high | middle << 8) | 230u << 16 | 0xFF000000u));
                auto& model = tile.add_material<MetallicRoughness>();
                model.normal_texture.texture = 0;
                tile.add_wall();
                if (back) // the wall's front looks away, and its normals with it
                    for (glm::vec3& n : tile.world.normal) n = -n;
                tile.world.tangent.assign(tile.scene.vertices, glm::vec4(0, 1, 0, w));
                tile.cast();
                ShadeMemory memory;
                shade_tile(tile.hits, tile.world, {}, memory.targets);
                const glm::vec3 found = at(memory.targets.normal, 8, 8, tile.hits.size);
                // In front: n (0, 0, 1), t (0, 1, 0), b = w n x t = (-w, 0, 0). Seen from behind, the
                // normal of the front, with n (0, 0, -1) and b (w, 0, 0), is turned round as a whole.
                const float turned = back ? -1.0f : 1.0f;
                const glm::vec3 bitangent(back ? w : -w, 0, 0);
                const glm::vec3 along = green ? bitangent : glm::vec3(0, 1, 0);
                const glm::vec3 expected = turned * (0.6f * along + 0.8f * glm::vec3(0, 0, turned));
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(found[c], expected[c], 0.008f) << green << w << back;
            }
}

TEST(Maps, WithoutLevelsOrCoordinatesAreWhite)
{
    TileScene tile;
    tile.scene.textures.emplace_back();
    tile.scene.textures.push_back(plain(0xFF000000));
    tile.add_material<Unlit>() = {.color = {0.5f, 0.25f, 1}, .texture = {.texture = 0}};
    tile.add_wall();
    tile.cast();
    ShadeMemory memory;
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    EXPECT_EQ(at(memory.targets.color, 2, 2, tile.hits.size), glm::vec3(0.5f, 0.25f, 1));
    std::get<Unlit>(tile.scene.materials.back().model).texture = {.texture = 1, .uv_set = 1};
    shade_tile(tile.hits, tile.world, {}, memory.targets);
    EXPECT_EQ(at(memory.targets.color, 2, 2, tile.hits.size), glm::vec3(0.5f, 0.25f, 1));
}

} // namespace
} // namespace firsthit
