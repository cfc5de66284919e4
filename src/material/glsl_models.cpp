// glsl_models.cpp - the models of models.h as one text for shaders.
#include "material/glsl_models.h"

#include "material/texels.h"

#include <fmt/format.h>

#include <bit>
#include <cstddef>
#include <string_view>

namespace firsthit {
namespace {

/// struct Phong { vec3 ambient; ... };
std::string struct_of(const ModelInfo& model)
{
    std::string text = fmt::format("struct {} {{\n", model.type);
    for (const ModelField& field : model.fields)
        text += fmt::format("    {} {};\n", field.floats == 3 ? "vec3" : "float", field.name);
    return text + "};\n";
}

/// Phong fetch_phong(int first): from its texels, the first of which is given.
std::string fetch_of(const ModelInfo& model)
{
    constexpr std::string_view kComponents = "xyzw";
    const ModelLayout layout = model_layout(model.fields);
    std::string text = fmt::format("{} fetch_{}(int first)\n{{\n", model.type, model.text);
    for (int texel = 0; texel < layout.texels; ++texel)
        text += fmt::format("    vec4 texel{0} = texelFetch(materials, first + {0});\n", texel);
    text += fmt::format("    return {}(", model.type);
    for (std::size_t k = 0; k < model.fields.size(); ++k) {
        const TexelPlace& place = layout.place[k];
        text += fmt::format("{}texel{}.{}", k > 0 ? ", " : "", place.texel,
            kComponents.substr(std::size_t(place.component), std::size_t(model.fields[k].floats)));
    }
    return text + ");\n}\n";
}

/// A function's body: `statement` for the model that inputs.model says, {0} being its number and {1}
/// its text's name.
std::string choice(std::string_view statement, bool only_reflecting = false)
{
    std::string text;
    for (int number = 0; number < kModelCount; ++number) {
        const ModelInfo& model = kModels[number];
        if (only_reflecting && !model.reflects) continue;
        text += fmt::format("    if (inputs.model == {}) ", number) +
                fmt::format(fmt::runtime(statement), number, model.text) + "\n";
    }
    return text;
}

std::string number_of_model()
{
    return fmt::format("#if FIRSTHIT_ONLY_MODEL >= 0\n"
                       "    inputs.model = FIRSTHIT_ONLY_MODEL;\n"
                       "#else\n"
                       "    inputs.model = material_header(material) & {};\n"
                       "#endif\n",
        kHeaderTexture - 1);
}

} // namespace

std::string glsl_models()
{
    std::string text = "// models.glsl - written by src/material/glsl_models.cpp.\n";
    for (const ModelInfo& model : kModels)
        text += struct_of(model) + fmt::format("#include \"{}.glsl\"\n", model.text);

    text += fmt::format("const int kMaterialTexels = {};\n", kMaterialTexels);
    text += "int material_header(uint material)\n{\n"
            "    return floatBitsToInt(texelFetch(materials, kMaterialTexels * int(material)).w);\n"
            "}\n";
    text += fmt::format("int material_texture(uint material)\n{{\n"
                        "    return material_header(material) >> {}; // -1: none\n}}\n",
        std::countr_zero(unsigned(kHeaderTexture)));
    for (const ModelInfo& model : kModels) text += fetch_of(model);

    text += "struct Inputs {\n    int model;\n";
    for (const ModelInfo& model : kModels)
        text += fmt::format("    {}Inputs {};\n", model.type, model.text);
    text += "};\n";
    text += "Inputs inputs_of(uint material, vec3 texture_color)\n{\n"
            "    Inputs inputs;\n"
            "    int first = kMaterialTexels * int(material);\n" +
            number_of_model() + choice("inputs.{1} = inputs_of(fetch_{1}(first), texture_color);") +
            "    return inputs;\n}\n";
    text += "vec3 albedo(Inputs inputs)\n{\n" + choice("return albedo(inputs.{1});") +
            "    return vec3(0.0);\n}\n";
    text += "vec3 emitted(Inputs inputs, vec3 ambient_light)\n{\n" +
            choice("return emitted(inputs.{1}, ambient_light);") + "    return vec3(0.0);\n}\n";
    text += "bool reflects(Inputs inputs)\n{\n" + choice("return true;", true) +
            "    return false;\n}\n";
    text += "vec3 reflected(Inputs inputs, Surface surface, vec3 to_light, vec3 light)\n{\n" +
            choice("return reflected(inputs.{1}, surface, to_light, light);", true) +
            "    return vec3(0.0);\n}\n";
    return text;
}

} // namespace firsthit
