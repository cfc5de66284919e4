// texels_test.cpp - materials as shaders fetch them hold every parameter of every model.
#include "material/texels.h"

#include "material/glsl_models.h"

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
        EXPECT_LE(layout.texels, kMaterialTexels);
        std::set<int> taken = {3}; // the header
        for (std::size_t k = 0; k < model.fields.size(); ++k) {
            const TexelPlace& place = layout.place[k];
            EXPECT_LE(place.component + model.fields[k].floats, 4) << model.fields[k].name;
            for (int c = 0; c < model.fields[k].floats; ++c) {
                const int number = 4 * place.texel + place.component + c;
                EXPECT_LT(number, 4 * kMaterialTexels);
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
    const MaterialTexels texels = material_texels(material, 5);
    EXPECT_EQ(glm::vec3(texels[0]), glm::vec3(1, 2, 3));
    EXPECT_EQ(glm::vec3(texels[1]), glm::vec3(4, 5, 6));
    EXPECT_EQ(texels[2], glm::vec4(7, 8, 9, 10));
    EXPECT_EQ(std::bit_cast<std::int32_t>(texels[0].w), 5 * kHeaderTexture + 0);
    // No texture, as a shader takes the header apart.
    const auto none = std::bit_cast<std::int32_t>(material_texels(material, -1)[0].w);
    EXPECT_EQ(none >> std::countr_zero(unsigned(kHeaderTexture)), -1);
    EXPECT_EQ(none & (kHeaderTexture - 1), 0);
}

TEST(GlslModels, FetchEachFieldFromItsTexel)
{
    const std::string text = glsl_models();
    EXPECT_NE(
        text.find("return Phong(texel0.xyz, texel1.xyz, texel2.xyz, texel2.w);"), std::string::npos)
        << text;
    EXPECT_NE(text.find("#include \"phong.glsl\""), std::string::npos);
}

} // namespace
} // namespace firsthit
