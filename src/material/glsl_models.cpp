// glsl_models.cpp - writes GLSL for the shading models of models.h.
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

/// Phong fetch_phong(int first): loads a material from its texels; `first` is the number of the
/// first.
std::string fetch_of(const ModelInfo& model)
{
    constexpr std::string_view kComponents = "xyzw";
    const ModelLayout layout = model_layout(model.fields);
    std::string text = fmt::format("{} fetch_{}(int first)\n{{\n", model.type, model.text);
    for (int texel = 0; texel < layout.texels; ++texel)
        text += fmt::format("    vec4 texel{0} = texelFetch(materials, first + {0});\n", texel);
    text += fmt::format("    return {}(", model.type);
    for (std::size_t k = 0; k < model.fields.size(); ++k) {
        const TexelComponent& at = layout.field[k];
        text += fmt::format("{}texel{}.{}", k > 0 ? ", " : "", at.texel,
            kComponents.substr(std::size_t(at.component), std::size_t(model.fields[k].floats)));
    }
    return text + ");\n}\n";
}

/// Executes `statement` for the model whose number is that of the GLSL expression `number`, if `has`
/// is true for it. In the statement, {0} stands for the model's number and {1} for its name in GLSL.
template <class Has>
std::string choice(std::string_view number, std::string_view statement, const Has& has)
{
    std::string text;
    for (int model = 0; model < kModelCount; ++model)
        if (has(kModels[model]))
            text += fmt::format("    if ({} == {}) ", number, model) +
                    fmt::format(fmt::runtime(statement), model, kModels[model].text) + "\n";
    return text;
}

/// Of inputs.model.
std::string choice(std::string_view statement, bool only_reflecting = false)
{
    return choice("inputs.model", statement,
        [&](const ModelInfo& model) { return !only_reflecting || model.reflects; });
}

/// Of inputs.model, for models that reflect environments.
std::string rough_choice(std::string_view statement)
{
    return choice("inputs.model", statement,
        [](const ModelInfo& model) { return reflects_environment(model); });
}

/// What is known of a model's maps.
std::string maps_text()
{
    std::string text = "int map_count(int model)\n{\n";
    for (int model = 0; model < kModelCount; ++model)
        text += fmt::format("    if (model == {}) return {};\n", model, kModels[model].maps.size());
    text += "    return 0;\n}\nint normal_map(int model)\n{\n";
    for (int model = 0; model < kModelCount; ++model)
        text += fmt::format(
            "    if (model == {}) return {};\n", model, normal_map(kModels[model].maps));
    text += "    return -1;\n}\n"
            "float normal_scale(uint material, int model)\n{\n"
            "    int first = kMaterialTexels * int(material);\n" +
            choice("model", "return fetch_{1}(first).normal_scale;",
                [](const ModelInfo& model) { return normal_map(model.maps) >= 0; }) +
            "    return 1.0;\n}\n";
    return text;
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
    text += fmt::format("int material_model(uint material)\n{{\n"
                        "#if FIRSTHIT_ONLY_MODEL >= 0\n"
                        "    return FIRSTHIT_ONLY_MODEL;\n"
                        "#else\n"
                        "    return material_header(material) & {};\n"
                        "#endif\n}}\n",
        kHeaderTexture - 1);
    text += fmt::format(
        "const int kFirstMapTexel = {};\nconst int kMapTexels = {};\n", kFirstMapTexel, kMapTexels);
    for (const ModelInfo& model : kModels) text += fetch_of(model);
    text += maps_text();

    text += "struct Inputs {\n    int model;\n";
    for (const ModelInfo& model : kModels)
        text += fmt::format("    {}Inputs {};\n", model.type, model.text);
    text += "};\n";
    text += "Inputs inputs_of(uint material, vec3 texture_color, MapColors maps)\n{\n"
            "    Inputs inputs;\n"
            "    int first = kMaterialTexels * int(material);\n"
            "    inputs.model = material_model(material);\n" +
            choice("inputs.model", "inputs.{1} = inputs_of(fetch_{1}(first), texture_color);",
                [](const ModelInfo& model) { return model.maps.empty(); }) +
            choice("inputs.model", "inputs.{1} = inputs_of(fetch_{1}(first), maps);",
                [](const ModelInfo& model) { return !model.maps.empty(); }) +
            "    return inputs;\n}\n";
    text += "vec3 albedo(Inputs inputs)\n{\n" + choice("return albedo(inputs.{1});") +
            "    return vec3(0.0);\n}\n";
    text += "vec3 emitted(Inputs inputs, vec3 ambient_light)\n{\n" +
            choice("return emitted(inputs.{1}, ambient_light);") + "    return vec3(0.0);\n}\n";
    text += "bool reflects(Inputs inputs)\n{\n" + choice("return true;", true) +
            "    return false;\n}\n";
    text += "bool reflects_environment(Inputs inputs)\n{\n" + rough_choice("return true;") +
            "    return false;\n}\n";
    text += "vec3 surrounded(Inputs inputs, AroundLight around)\n{\n" +
            rough_choice("return surrounded(inputs.{1}, around);") + "    return vec3(0.0);\n}\n";
    for (const char* value : {"metallic", "roughness"})
        text += fmt::format("float {}(Inputs inputs)\n{{\n", value) +
                rough_choice(fmt::format("return {}(inputs.{{1}});", value)) +
                "    return 0.0;\n}\n";
    text += "vec3 emission(Inputs inputs)\n{\n" + rough_choice("return emission(inputs.{1});") +
            "    return vec3(0.0);\n}\n";
    text += "vec3 scattered(Inputs inputs, vec3 light)\n{\n" +
            choice("return scattered(inputs.{1}, light);", true) + "    return vec3(0.0);\n}\n";
    text += "vec3 reflected(Inputs inputs, Surface surface, vec3 to_light, vec3 light)\n{\n" +
            choice("return reflected(inputs.{1}, surface, to_light, light);", true) +
            "    return vec3(0.0);\n}\n";
    return text;
}

} // namespace firsthit
