// gpu_models_test.cpp - the gpu engine shades every model as the cpu engine does.
#include "gl/gpu_pictures.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <variant>

namespace firsthit {
namespace {

class GpuModels : public test::OnGpu {
  protected:
    /// Every `every`-th material shows its diffuse colour unlit.
    void make_unlit(std::size_t every)
    {
        for (std::size_t m = 0; m < scene.materials.size(); m += every) {
            const Phong phong = std::get<Phong>(scene.materials[m].model);
            scene.materials[m].model =
                Unlit{.color = phong.diffuse, .texture = {.texture = phong.texture}};
        }
    }
};

/// Two textures of data that wrap in different ways.
Texture data_texture(unsigned seed, Wrap wrap, bool nearest)
{
    Picture picture{16, 16, {}};
    for (unsigned k = 0; k < 256; ++k) {
        seed = seed * 1664525u + 1013904223u;
        // Smooth enough that rounding cannot be seen.
        const auto channel = [&](unsigned shift) { return 96 + (seed >> shift) % 64; };
        picture.pixel.push_back(
            channel(8) | channel(14) << 8 | (channel(20) + 96) << 16 | 0xFF000000u);
    }
    Texture texture("data", picture, Encoding::linear);
    texture.set_sampler({.wrap_u = wrap, .wrap_v = wrap, .nearest = nearest});
    return texture;
}

TEST_F(GpuModels, MetallicRoughnessWithAllMapsIsThatOfTheCpuEngine)
{
    if (!context) return;
    load("builtin:robots", 2.5);
    scene.textures.push_back(data_texture(1, Wrap::mirror, false));
    scene.textures.push_back(data_texture(2, Wrap::clamp, false));
    const auto last = std::int32_t(scene.textures.size()) - 1;
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        if (m % 4 == 3) continue; // Phong's
        const Phong phong = std::get<Phong>(scene.materials[m].model);
        const TextureRef colors{
            .texture = phong.texture, .transform = {0.5f, 0.25f, -0.5f, 1, 0.1f, 0}};
        const TextureRef first{.texture = last - 1, .uv_set = 1};
        const TextureRef second{
            .texture = last, .uv_set = int(m % 2), .transform = {3, 0, 0, 3, 1, 1}};
        scene.materials[m].model = MetallicRoughness{.base_color = phong.diffuse,
            .metallic = 0.7f,
            .roughness = 0.8f,
            .emission = glm::vec3(0.05f),
            .base_color_texture = colors,
            .metallic_roughness_texture = first,
            .normal_texture = second,
            .occlusion_texture = first,
            .emission_texture = second,
            .specular_texture = first};
    }
    for (std::size_t v = 0; v < scene.vertices; ++v) {
        const glm::vec2 uv = scene.uv[v];
        scene.uv1.push_back({uv.y * 2 - 1, uv.x});
        scene.color.push_back({0.5f + 0.5f * float(v % 5) / 4, 0.75f, 1, 1});
        const glm::vec3 n = scene.normal[v];
        const glm::vec3 axis = std::abs(n.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
        scene.tangent.push_back(
            glm::vec4(glm::normalize(axis - n * glm::dot(n, axis)), v % 3 ? 1 : -1));
    }
    for (Light& light : scene.lights) {
        light.inverse_square = light.kind != Light::Kind::directional;
        light.range = 1000;
        light.color *= light.inverse_square ? 20000.0f : 1.0f;
    }
    pose_at(2.5);
    ASSERT_EQ(world.tangent.size(), scene.vertices);
    settings.shadows = Shadows::map;
    settings.aovs = {Aov::normal, Aov::albedo};
    render_both("maps");
    EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), 90);
    EXPECT_GE(test::psnr(gpu_film[Aov::albedo].value, cpu_film[Aov::albedo].value), 90);
    EXPECT_GE(test::psnr(gpu_film[Aov::normal].value, cpu_film[Aov::normal].value), 90);
    float most = 0;
    for (const float value : cpu_film.color.value) most = std::max(most, value);
    EXPECT_GT(most, 0.2f) << "there is light";
}

TEST_F(GpuModels, SamplersAreObeyedAsByTheCpuEngine)
{
    if (!context) return;
    for (const bool nearest : {false, true})
        for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp}) {
            load("builtin:robots", 2.5, 128);
            scene.textures[0] = data_texture(3, wrap, nearest);
            for (glm::vec2& uv : scene.uv) uv = uv * 0.37f - 0.21f;
            pose_at(2.5);
            settings.shadows = Shadows::none;
            render_both("sampler");
            // Next to a border between two texels rounding decides which is nearest.
            EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), nearest ? 50 : 85);
        }
}

TEST_F(GpuModels, SceneOfSeveralIsThatOfTheCpuEngine)
{
    if (!context) return;
    load("builtin:robots", 2.5);
    make_unlit(3);
    settings.shadows = Shadows::map;
    render_both("models");
    EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), 90);
}

TEST_F(GpuModels, ColoursOfVerticesAreThoseOfTheCpuEngine)
{
    if (!context) return;
    for (const char* const name : {"builtin:torus", "builtin:robots"}) {
        load(name, 2.5);
        settings.shadows = Shadows::none; // by default those of the cpu engine are exact
        render_both("plain");
        const std::vector<float> plain = cpu_film.color.value;
        for (std::size_t v = 0; v < scene.vertices; ++v)
            scene.color.push_back({0.1f * float(v % 9), 0.75f, 0.02f * float(v % 50), 1});
        pose_at(2.5);
        settings.aovs = {Aov::albedo};
        render_both("colours");
        EXPECT_LT(test::psnr(cpu_film.color.value, plain), 40) << "colours are seen";
        EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), 90) << name;
        EXPECT_GE(test::psnr(gpu_film[Aov::albedo].value, cpu_film[Aov::albedo].value), 90) << name;
    }
}

TEST_F(GpuModels, UnlitPictureIsItsAlbedo)
{
    if (!context) return;
    load("builtin:robots", 2.5);
    make_unlit(1);
    scene.background = {};
    settings.shadows = Shadows::map;
    settings.aovs = {Aov::albedo, Aov::lit};
    render_both("unlit");
    EXPECT_EQ(cpu_film.color.value, cpu_film[Aov::albedo].value);
    EXPECT_EQ(gpu_film.color.value, gpu_film[Aov::albedo].value);
    EXPECT_GE(test::psnr(gpu_film.color.value, cpu_film.color.value), 90);
    // Shadows are found nevertheless.
    const auto shadowed = [](const Film& film) {
        const std::vector<float>& lit = film[Aov::lit].value;
        return std::count(lit.begin(), lit.end(), 0.0f) != std::ptrdiff_t(lit.size()) &&
               std::count(lit.begin(), lit.end(), 1.0f) != std::ptrdiff_t(lit.size());
    };
    EXPECT_TRUE(shadowed(cpu_film));
    EXPECT_TRUE(shadowed(gpu_film));
}

} // namespace
} // namespace firsthit
