// texels_test.cpp - packed materials hold every parameter of every model.
#include "material/texels.h"

#include "material/glsl_models.h"

#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <set>
#include <string>

namespace firsthit {
namespace {

TEST(MaterialTexels, FieldsLieApartWithinTheTexels)
{
    for (const ModelInfo& model : kModels) {
        const ModelLayout layout = model_layout(model.fields);
        EXPECT_LE(layout.texels, kFirstMapTexel);
        EXPECT_LE(kFirstMapTexel + kMapTexels * int(model.maps.size()), kMaterialTexels);
        std::set<int> taken = {3}; // the header
        for (std::size_t k = 0; k < model.fields.size(); ++k) {
            const TexelComponent& at = layout.field[k];
            EXPECT_LE(at.component + model.fields[k].floats, 4) << model.fields[k].name;
            for (int c = 0; c < model.fields[k].floats; ++c) {
                const int number = 4 * at.texel + at.component + c;
                EXPECT_LT(number, 4 * kFirstMapTexel);
                EXPECT_TRUE(taken.insert(number).second) << model.fields[k].name;
            }
        }
    }
}

TEST(MaterialTexels, HoldPhongsParametersAndTheHeader)
{
    Material material;
    material.model =
        Phong{.ambient = {1, 2, 3}, .diffuse = {4, 5, 6}, .specular = {7, 8, 9}, .shininess = 10};
    const auto drawn = [](const TextureRef&) { return true; };
    const MaterialTexels texels = material_texels(material, 5, drawn);
    EXPECT_EQ(glm::vec3(texels[0]), glm::vec3(1, 2, 3));
    EXPECT_EQ(glm::vec3(texels[1]), glm::vec3(4, 5, 6));
    EXPECT_EQ(texels[2], glm::vec4(7, 8, 9, 10));
    EXPECT_EQ(std::bit_cast<std::int32_t>(texels[0].w), 5 * kHeaderTexture + 0);
    // No texture: decode the header as the shader does.
    const auto none = std::bit_cast<std::int32_t>(material_texels(material, -1, drawn)[0].w);
    EXPECT_EQ(none >> std::countr_zero(unsigned(kHeaderTexture)), -1);
    EXPECT_EQ(none & (kHeaderTexture - 1), 0);
}

TEST(MaterialTexels, HoldWhereEachMapIsSampled)
{
    Material material;
    MetallicRoughness model{.roughness = 0.25f, .emission = {1, 2, 3}};
    model.normal_texture = {.texture = 7, .uv_set = 1, .transform = {1, 2, 3, 4, 5, 6}};
    model.occlusion_texture.texture = 3;
    material.model = model;
    const MaterialTexels texels =
        material_texels(material, -1, [](const TextureRef& map) { return map.texture == 7; });
    const auto number = [](float bits) { return std::bit_cast<std::int32_t>(bits); };
    const auto map =
        std::size_t(kFirstMapTexel + kMapTexels * normal_map(kMapsOf<MetallicRoughness>));
    EXPECT_EQ(texels[map], glm::vec4(1, 2, 3, 4));
    EXPECT_EQ(glm::vec2(texels[map + 1]), glm::vec2(5, 6));
    EXPECT_EQ(number(texels[map + 1].z), 7);
    EXPECT_EQ(number(texels[map + 1].w), 1);
    EXPECT_EQ(number(texels[map + 3].z), -1) << "occlusion is not drawn";
    EXPECT_EQ(glm::vec3(texels[1]), glm::vec3(1, 2, 3));
    EXPECT_EQ(number(texels[0].w), -kHeaderTexture + 2);
}

TEST(GlslModels, FetchEachFieldFromItsTexel)
{
    const std::string text = glsl_models();
    EXPECT_NE(
        text.find("return Phong(texel0.xyz, texel1.xyz, texel2.xyz, texel2.w);"), std::string::npos)
        << text;
    EXPECT_NE(text.find("#include \"phong.glsl\""), std::string::npos);
    EXPECT_NE(text.find("if (model == 2) return 6;"), std::string::npos) << text;
}

} // namespace
} // namespace firsthit
