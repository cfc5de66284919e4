// scene_materials_test.cpp - the materials, textures and lights of scenes of glTF documents.
#include "readers/gltf/gltf_text.h"
#include "readers/gltf/read_gltf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

namespace firsthit::gltf {
namespace {

/// 2 x 1 pixels: (255, 128, 0, 255), (0, 64, 32, 51).
const std::string kPixels =
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAAEUlEQVR42mP438Dwn8FBwRgAEa8DEtAnz18AAAAASU"
    "VORK5CYII=";

/// A triangle with one material, texture coordinates and one picture in two textures.
firsthit::Scene scene_of(const std::string& material, const std::string& more = "",
    const std::vector<float>& uv = {0, 0, 1, 0, 0, 1})
{
    std::vector<float> numbers = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1};
    numbers.insert(numbers.end(), uv.begin(), uv.end());
    const std::string bytes = bytes_of(numbers);
    const std::string length = std::to_string(bytes.size());
    return read_gltf("t.gltf",
        R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": )" + length +
            R"(, "uri": "data:application/octet-stream;base64,)" + base64(bytes) +
            R"("}], "bufferViews": [{"buffer": 0, "byteLength": )" + length + R"(}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
            {"bufferView": 0, "byteOffset": 36, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 0, "byteOffset": 72, "componentType": 5126, "count": 3, "type": "VEC2"}],
        "images": [{"uri": "data:image/png;base64,)" +
            kPixels + R"("}],
        "samplers": [{}, {"wrapS": 33071, "wrapT": 33648, "magFilter": 9728}],
        "textures": [{"source": 0, "sampler": 0}, {"source": 0, "sampler": 1}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "material": 0}]}],
        "materials": [)" +
            material + R"(], "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}])" + more + "}",
        {}, {});
}

MetallicRoughness model_of(const firsthit::Scene& scene)
{
    return std::get<MetallicRoughness>(scene.materials.at(0).model);
}

TEST(GltfSceneMaterials, AreMetallicRoughness)
{
    const firsthit::Scene scene =
        scene_of(R"({"name": "m", "alphaMode": "MASK", "alphaCutoff": 0.25, "doubleSided": true,
        "pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 0.5, "roughnessFactor": 0.75,
            "baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 0}},
        "normalTexture": {"index": 1, "scale": 2}, "occlusionTexture": {"index": 0, "strength": 0.5},
        "emissiveTexture": {"index": 0}, "emissiveFactor": [0.5, 0.25, 1],
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 4}}})");
    const firsthit::Material& material = scene.materials.at(0);
    EXPECT_EQ(material.alpha, firsthit::AlphaMode::mask);
    EXPECT_EQ(material.alpha_cutoff, 0.25f);
    EXPECT_EQ(material.opacity, 0.4f);
    EXPECT_TRUE(material.double_sided);
    const MetallicRoughness m = model_of(scene);
    EXPECT_EQ(material.opacity_texture.texture, m.base_color_texture.texture);
    EXPECT_EQ(m.base_color, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(m.metallic, 0.5f);
    EXPECT_EQ(m.roughness, 0.75f);
    EXPECT_EQ(m.emission, glm::vec3(2, 1, 4));
    EXPECT_NEAR(m.f0.x, 0.04f, 1e-7f);
    EXPECT_EQ(m.specular, 1.0f);
    EXPECT_EQ(m.normal_scale, 2.0f);
    EXPECT_EQ(m.occlusion_strength, 0.5f);
    // Colours are one texture, data another, and what is sampled otherwise a third.
    EXPECT_EQ(scene.textures.size(), 3u);
    EXPECT_EQ(m.emission_texture.texture, m.base_color_texture.texture);
    EXPECT_EQ(m.occlusion_texture.texture, m.metallic_roughness_texture.texture);
    const auto texel = [&](const TextureRef& map) {
        return scene.textures.at(std::size_t(map.texture)).color(0, 0, 0);
    };
    EXPECT_NEAR(texel(m.base_color_texture).g, 0.21586, 1e-4);
    EXPECT_NEAR(texel(m.occlusion_texture).g, 128 / 255.0, 1e-4);
    const firsthit::Sampler& sampler =
        scene.textures.at(std::size_t(m.normal_texture.texture)).sampler();
    EXPECT_EQ(sampler.wrap_u, firsthit::Wrap::clamp);
    EXPECT_EQ(sampler.wrap_v, firsthit::Wrap::mirror);
    EXPECT_TRUE(sampler.nearest);
    EXPECT_EQ(scene.tangent.size(), 3u);
    EXPECT_EQ(scene.warnings.size(), 0u);
}

TEST(GltfSceneMaterials, HaveTheReflectanceOfTheirExtensions)
{
    EXPECT_NEAR(model_of(scene_of(R"({"extensions": {"KHR_materials_ior": {"ior": 2}}})")).f0.y,
        1 / 9.0, 1e-6);
    EXPECT_EQ(
        model_of(scene_of(R"({"extensions": {"KHR_materials_ior": {"ior": 0}}})")).f0.y, 1.0f);
    const firsthit::Scene scene =
        scene_of(R"({"extensions": {"KHR_materials_specular": {"specularFactor": 0.5,
        "specularColorFactor": [1, 0.5, 2], "specularTexture": {"index": 0}}}})");
    const MetallicRoughness m = model_of(scene);
    EXPECT_NEAR(m.f0.x, 0.04, 1e-6);
    EXPECT_NEAR(m.f0.y, 0.02, 1e-6);
    EXPECT_NEAR(m.f0.z, 0.08, 1e-6);
    EXPECT_EQ(m.specular, 0.5f);
    const glm::vec4 texel =
        scene.textures.at(std::size_t(m.specular_texture.texture)).color(0, 1, 0);
    EXPECT_EQ(glm::vec3(texel), glm::vec3(1)) << "without a colour texture";
    EXPECT_NEAR(texel.a, 0.2, 1e-4);
}

TEST(GltfSceneMaterials, ConvertSpecularGlossiness)
{
    const firsthit::Scene scene =
        scene_of(R"({"alphaMode": "BLEND", "extensions": {"KHR_materials_pbrSpecularGlossiness": {
        "diffuseFactor": [0.5, 0.25, 0.125, 0.75], "specularFactor": [0.25, 0.5, 1], "glossinessFactor": 0.5,
        "specularGlossinessTexture": {"index": 0}}}})");
    const MetallicRoughness m = model_of(scene);
    EXPECT_EQ(m.base_color, glm::vec3(0.5f, 0.25f, 0.125f));
    EXPECT_EQ(m.metallic, 0.0f);
    EXPECT_EQ(m.f0, glm::vec3(0.25f, 0.5f, 1));
    EXPECT_EQ(scene.materials[0].opacity, 0.75f);
    EXPECT_EQ(scene.materials[0].alpha, firsthit::AlphaMode::blend);
    const firsthit::Texture& rough =
        scene.textures.at(std::size_t(m.metallic_roughness_texture.texture));
    EXPECT_NEAR(m.roughness * rough.color(0, 0, 0).g, 0.5, 0.002); // glossiness 0.5 * 1
    EXPECT_NEAR(m.roughness * rough.color(0, 1, 0).g, 0.9, 0.002); // 0.5 * 0.2
    const firsthit::Texture& colors = scene.textures.at(std::size_t(m.specular_texture.texture));
    EXPECT_NEAR(colors.color(0, 0, 0).g, 0.21586, 1e-4);
    EXPECT_EQ(colors.color(0, 1, 0).a, 1.0f);
    // Without a texture.
    EXPECT_EQ(
        model_of(
            scene_of(
                R"({"extensions": {"KHR_materials_pbrSpecularGlossiness": {"glossinessFactor": 0.25}}})"))
            .roughness,
        0.75f);
}

TEST(GltfSceneMaterials, CanBeUnlit)
{
    const firsthit::Scene scene =
        scene_of(R"({"pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 1],
        "baseColorTexture": {"index": 1}}, "extensions": {"KHR_materials_unlit": {}}})");
    const Unlit unlit = std::get<Unlit>(scene.materials.at(0).model);
    EXPECT_EQ(unlit.color, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(unlit.texture.texture, 0);
}

TEST(GltfSceneMaterials, WarnOnceOfWhatIsNotDrawn)
{
    const std::string coat = R"({"extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 1},
        "KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_volume": {"thicknessFactor": 1},
        "KHR_materials_sheen": {"sheenColorFactor": [1, 0, 0]}}})";
    const firsthit::Scene scene = scene_of(coat + ", " + coat);
    ASSERT_EQ(scene.warnings.size(), 4u);
    EXPECT_EQ(scene.warnings[0],
        "t.gltf: KHR_materials_transmission is not drawn yet: surfaces are not clear");
    EXPECT_EQ(scene_of(R"({"extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 0}}})")
                  .warnings.size(),
        0u);
}

/// Against the extension's own words, applied as complex numbers to coordinates that count v from the top.
TEST(GltfSceneMaterials, SampleTexturesWhereTransformsSay)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> number(-2, 2);
    for (int k = 0; k < 50; ++k) {
        const float u = number(random), v = number(random), x = number(random), y = number(random);
        const float turn = number(random), sx = number(random), sy = number(random);
        const auto text = [](float value) { return std::to_string(value); };
        const firsthit::Scene scene =
            scene_of(R"({"emissiveTexture": {"index": 0, "extensions": {"KHR_texture_transform":
            {"offset": [)" +
                         text(x) + ", " + text(y) + R"(], "rotation": )" + text(turn) +
                         R"(, "scale": [)" + text(sx) + ", " + text(sy) + "]}}}}",
                "", {u, v, 1, 0, 0, 1});
        const TextureRef map = model_of(scene).emission_texture;
        const glm::vec2 at = map.transform * glm::vec3(scene.uv[0], 1);
        // Counter-clockwise as it is seen, with v downwards: a turn by a negative angle.
        const auto moved = std::complex<double>(x, y) +
                           std::polar(1.0, double(-turn)) * std::complex<double>(sx * u, sy * v);
        EXPECT_NEAR(at.x, moved.real(), 2e-5);
        EXPECT_NEAR(at.y, 1 - moved.imag(), 2e-5);
    }
    EXPECT_EQ(model_of(scene_of(R"({"emissiveTexture": {"index": 0}})")).emission_texture.transform,
        glm::mat3x2(1.0f));
}

TEST(GltfSceneLights, FadeWithDistance)
{
    const firsthit::Scene scene =
        scene_of("{}", R"(, "extensions": {"KHR_lights_punctual": {"lights": [
        {"type": "point", "intensity": 3, "range": 5, "color": [1, 0.5, 0]}, {"type": "directional", "intensity": 2}]}})");
    EXPECT_EQ(scene.lights.size(), 0u) << "no node has them";
    const firsthit::Scene lit = read_gltf("t.gltf", R"({"asset": {"version": "2.0"}, "nodes": [
        {"extensions": {"KHR_lights_punctual": {"light": 0}}}, {"extensions": {"KHR_lights_punctual": {"light": 1}}}],
        "extensionsUsed": ["KHR_lights_punctual"], "extensions": {"KHR_lights_punctual": {"lights": [
        {"type": "spot", "intensity": 3, "range": 5, "color": [1, 0.5, 0]}, {"type": "directional", "intensity": 2}]}}})",
        {}, {});
    ASSERT_EQ(lit.lights.size(), 2u);
    EXPECT_TRUE(lit.lights[0].inverse_square);
    EXPECT_EQ(lit.lights[0].range, 5.0);
    EXPECT_EQ(lit.lights[0].color, glm::vec3(3, 1.5f, 0));
    EXPECT_FALSE(lit.lights[1].inverse_square);
    EXPECT_EQ(lit.lights[1].color, glm::vec3(2));
}

} // namespace
} // namespace firsthit::gltf
