// material_test.cpp - the materials, textures and samplers of glTF documents.
#include "readers/gltf/gltf_text.h"

#include <gtest/gtest.h>

namespace firsthit::gltf {
namespace {

const std::string kTextures = R"("images": [{"uri": "a.png"}, {"uri": "b.webp"}],
    "samplers": [{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728, "minFilter": 9985}],
    "textures": [{"source": 0, "sampler": 0}, {"source": 0, "extensions": {"EXT_texture_webp": {"source": 1}}},
        {"extensions": {"KHR_texture_basisu": {"source": 1}}}])";

Material read(const std::string& material)
{
    return read_members(kTextures + R"(, "materials": [)" + material + "]").materials.at(0);
}

TEST(GltfMaterial, HasTheDefaultsOfTheSpecification)
{
    const Material m = read("{}");
    EXPECT_EQ(m.base_color, glm::vec4(1.0f));
    EXPECT_EQ(m.metallic, 1.0f);
    EXPECT_EQ(m.roughness, 1.0f);
    EXPECT_EQ(m.emissive, glm::vec3(0.0f));
    EXPECT_EQ(m.alpha_mode, AlphaMode::kOpaque);
    EXPECT_EQ(m.alpha_cutoff, 0.5f);
    EXPECT_FALSE(
        m.double_sided || m.unlit || m.base_color_texture || m.ior || m.specular || m.volume);
}

TEST(GltfMaterial, ReadsAllMembers)
{
    const Material m =
        read(R"({"name": "m", "alphaMode": "MASK", "alphaCutoff": 0.25, "doubleSided": true,
        "pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 0.5, "roughnessFactor": 0.75,
            "baseColorTexture": {"index": 1, "texCoord": 2}, "metallicRoughnessTexture": {"index": 0}},
        "normalTexture": {"index": 0, "scale": 2}, "occlusionTexture": {"index": 0, "strength": 0.5},
        "emissiveTexture": {"index": 0}, "emissiveFactor": [1, 2, 3]})");
    EXPECT_EQ(m.name, "m");
    EXPECT_EQ(m.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(m.metallic, 0.5f);
    EXPECT_EQ(m.roughness, 0.75f);
    EXPECT_EQ(m.base_color_texture.texture, 1);
    EXPECT_EQ(m.base_color_texture.tex_coord, 2);
    EXPECT_EQ(m.metallic_roughness_texture.texture, 0);
    EXPECT_EQ(m.normal_scale, 2.0f);
    EXPECT_EQ(m.occlusion_strength, 0.5f);
    EXPECT_EQ(m.emissive, glm::vec3(1, 2, 3));
    EXPECT_EQ(m.alpha_mode, AlphaMode::kMask);
    EXPECT_EQ(m.alpha_cutoff, 0.25f);
    EXPECT_TRUE(m.double_sided);
}

TEST(GltfMaterial, ReadsTextureTransforms)
{
    const TextureInfo info = read(
        R"({"emissiveTexture": {"index": 0, "texCoord": 1, "extensions": {"KHR_texture_transform":
        {"offset": [1, 2], "rotation": 3, "scale": [4, 5], "texCoord": 6}}}})")
                                 .emissive_texture;
    EXPECT_EQ(info.offset, glm::vec2(1, 2));
    EXPECT_EQ(info.rotation_rad, 3.0f);
    EXPECT_EQ(info.scale, glm::vec2(4, 5));
    EXPECT_EQ(info.tex_coord, 6);
}

TEST(GltfMaterial, ReadsExtensions)
{
    const Material m = read(R"({"extensions": {"KHR_materials_unlit": {},
        "KHR_materials_emissive_strength": {"emissiveStrength": 5}, "KHR_materials_ior": {"ior": 1.25},
        "KHR_materials_specular": {"specularFactor": 0.5, "specularColorFactor": [1, 2, 3], "specularColorTexture": {"index": 1}},
        "KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0, 0, 1, 1], "glossinessFactor": 0.5},
        "KHR_materials_transmission": {"transmissionFactor": 0.75},
        "KHR_materials_volume": {"thicknessFactor": 2, "attenuationDistance": 3, "attenuationColor": [0, 1, 0]},
        "KHR_materials_clearcoat": {"clearcoatFactor": 1, "clearcoatNormalTexture": {"index": 0, "scale": 0.5}},
        "KHR_materials_sheen": {"sheenColorFactor": [0, 0, 1], "sheenRoughnessFactor": 0.5}}})");
    EXPECT_TRUE(m.unlit);
    EXPECT_EQ(m.emissive_strength, 5.0f);
    EXPECT_EQ(m.ior, 1.25f);
    EXPECT_EQ(m.specular->factor, 0.5f);
    EXPECT_EQ(m.specular->color, glm::vec3(1, 2, 3));
    EXPECT_EQ(m.specular->color_texture.texture, 1);
    EXPECT_EQ(m.specular_glossiness->diffuse, glm::vec4(0, 0, 1, 1));
    EXPECT_EQ(m.specular_glossiness->specular, glm::vec3(1.0f));
    EXPECT_EQ(m.specular_glossiness->glossiness, 0.5f);
    EXPECT_EQ(m.transmission->factor, 0.75f);
    EXPECT_EQ(m.volume->thickness, 2.0f);
    EXPECT_EQ(m.volume->attenuation_distance, 3.0f);
    EXPECT_EQ(m.volume->attenuation_color, glm::vec3(0, 1, 0));
    EXPECT_EQ(m.clearcoat->factor, 1.0f);
    EXPECT_EQ(m.clearcoat->normal_scale, 0.5f);
    EXPECT_EQ(m.sheen->color, glm::vec3(0, 0, 1));
    EXPECT_EQ(m.sheen->roughness, 0.5f);
}

TEST(GltfMaterial, MovesValuesIntoTheirRange)
{
    const Document document = read_members(
        R"("materials": [{"alphaMode": "GLASS", "pbrMetallicRoughness": {"metallicFactor": 2},
        "extensions": {"KHR_materials_ior": {"ior": 0}}}, {"extensions": {"KHR_materials_ior": {"ior": 0.5}}}])");
    EXPECT_EQ(document.materials[0].metallic, 1.0f);
    EXPECT_EQ(document.materials[0].ior, 0.0f);
    EXPECT_EQ(document.materials[1].ior, 1.0f);
    EXPECT_EQ(warnings_of(document),
        "t.gltf: materials[0].alphaMode 'GLASS' is none of OPAQUE, MASK, BLEND; OPAQUE is used\n"
        "t.gltf: materials[0]: metallicFactor is 2, 1 is used\n"
        "t.gltf: materials[1]: ior is 0.5, 1 is used\n");
}

TEST(GltfMaterial, ReadsSamplersAndChoosesImages)
{
    const Document document = read_members(kTextures);
    const Sampler& sampler = document.textures[0].sampler;
    EXPECT_EQ(sampler.wrap_s, Wrap::kClampToEdge);
    EXPECT_EQ(sampler.wrap_t, Wrap::kMirroredRepeat);
    EXPECT_EQ(sampler.mag_filter, Filter::kNearest);
    EXPECT_EQ(sampler.min_filter, Filter::kLinearMipmapNearest);
    EXPECT_EQ(document.textures[1].sampler.wrap_s, Wrap::kRepeat);
    EXPECT_EQ(document.textures[1].image, FIRSTHIT_WITH_WEBP ? 1 : 0);
    EXPECT_EQ(document.textures[2].image, 1);
    EXPECT_EQ(warnings_of(read_members(R"("samplers": [{"wrapS": 7}], "textures": [{}])")),
        "t.gltf: samplers[0].wrapS is 7, which is unknown; the default is used\n"
        "t.gltf: textures[0] has no image that is supported; it is not shown\n");
}

TEST(GltfMaterial, RefusesTexturesThatAreNotThere)
{
    EXPECT_EQ(refusal(R"("materials": [{"normalTexture": {"index": 0}}])"),
        "t.gltf: materials[0].normalTexture.index: 0 is out of range, there are 0");
    EXPECT_EQ(refusal(R"("materials": [{"normalTexture": {}}])"),
        "t.gltf: materials[0].normalTexture.index: is missing");
    EXPECT_EQ(refusal(R"("textures": [{"source": 0}])"),
        "t.gltf: textures[0].source: 0 is out of range, there are 0");
    EXPECT_EQ(
        refusal(
            R"("materials": [{"extensions": {"KHR_materials_sheen": {"sheenColorTexture": {"index": 1}}}}])"),
        "t.gltf: materials[0].KHR_materials_sheen.sheenColorTexture.index: 1 is out of range, "
        "there are 0");
}

} // namespace
} // namespace firsthit::gltf
