// models.h - the table of shading models. The dispatch in C++ and in shaders, a model's number, and
// the positions of its parameters in the shaders' buffer (texels.h) follow from it.
//
// To add a model:
//   - add a struct of its parameters to include/firsthit/material.h, last in Material::Model;
//   - write its formulas in src/material/NAME.glsl, which C++ and shaders compile (see phong.glsl);
//   - add a line to FIRSTHIT_MODELS, and NAME.glsl to material/texts.inl and to gl/CMakeLists.txt;
//   - check the ranges of its parameters in scene/model/check_scene.cpp (it does not compile until
//     then).
#pragma once

#include <firsthit/scene.h>

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>

/// MODEL(struct, text, reflects, fields, maps)
///
/// struct    the struct of its parameters in firsthit/material.h
/// text      its formulas are in material/text.glsl
/// reflects  whether its surfaces reflect lights; if so, the text has a function `reflected`
/// fields    FIELD(struct, member) for each parameter that the formulas read, a float or a
///           glm::vec3
/// maps      MAP(struct, member) for each TextureRef, at most kMostMaps. Colours of vertices
///           multiply the first. `normal_texture` is the normal map. A model without maps has the
///           member `texture`, a number, which is sampled at Scene::uv
#define FIRSTHIT_MODELS(MODEL, FIELD, MAP)                                                         \
    MODEL(Phong, phong, true,                                                                      \
        FIELD(Phong, ambient) FIELD(Phong, diffuse) FIELD(Phong, specular)                         \
            FIELD(Phong, shininess), )                                                             \
    MODEL(Unlit, unlit, false, FIELD(Unlit, color), MAP(Unlit, texture))                           \
    MODEL(MetallicRoughness, metallic_roughness, true,                                             \
        FIELD(MetallicRoughness, base_color) FIELD(MetallicRoughness, emission)                    \
            FIELD(MetallicRoughness, metallic) FIELD(MetallicRoughness, f0)                        \
                FIELD(MetallicRoughness, roughness) FIELD(MetallicRoughness, specular) FIELD(      \
                    MetallicRoughness, normal_scale) FIELD(MetallicRoughness, occlusion_strength), \
        MAP(MetallicRoughness, base_color_texture) MAP(                                            \
            MetallicRoughness, metallic_roughness_texture) MAP(MetallicRoughness, normal_texture)  \
            MAP(MetallicRoughness, occlusion_texture) MAP(MetallicRoughness, emission_texture)     \
                MAP(MetallicRoughness, specular_texture))

/// Precedes a function parameter that a model does not use. GLSL defines it as nothing.
#define FIRSTHIT_UNUSED [[maybe_unused]]

namespace firsthit {

/// A parameter of a model.
struct ModelField {
    std::string_view name;
    std::size_t offset; // in the struct, bytes
    int floats;         // 1, or 3 for a vector
};

/// A texture of a model.
struct ModelMap {
    std::string_view name;
    std::size_t offset; // of its TextureRef in the struct, bytes
};

/// A shading model. Its number is its index in the table and in Material::Model.
struct ModelInfo {
    std::string_view type; // name of the struct
    std::string_view text; // name of the file of formulas, without .glsl
    bool reflects;
    std::span<const ModelField> fields;
    std::span<const ModelMap> maps;
};

namespace model_table {

template <class T>
constexpr int floats_of()
{
    static_assert(std::is_same_v<T, float> || std::is_same_v<T, glm::vec3>);
    return std::is_same_v<T, float> ? 1 : 3;
}

#define FIRSTHIT_FIELD(type, member)                                                               \
    {#member, offsetof(type, member), floats_of<decltype(type::member)>()},
#define FIRSTHIT_MAP(type, member) {#member, offsetof(type, member)},
#define FIRSTHIT_MODEL(type, text, reflects, fields, maps)                                         \
    inline constexpr ModelField text[] = {fields};                                                 \
    inline constexpr ModelMap text##_maps[] = {maps{"", 0}}; // and an end: arrays are not empty
FIRSTHIT_MODELS(FIRSTHIT_MODEL, FIRSTHIT_FIELD, FIRSTHIT_MAP)
#undef FIRSTHIT_MODEL
#undef FIRSTHIT_FIELD
#undef FIRSTHIT_MAP

} // namespace model_table

#define FIRSTHIT_NONE(type, member)
#define FIRSTHIT_MODEL(type, text, reflects, fields, maps)                                         \
    {#type, #text, reflects, model_table::text,                                                    \
        std::span(model_table::text##_maps).first(std::size(model_table::text##_maps) - 1)},
inline constexpr ModelInfo kModels[] = {
    FIRSTHIT_MODELS(FIRSTHIT_MODEL, FIRSTHIT_NONE, FIRSTHIT_NONE)};
#undef FIRSTHIT_MODEL
inline constexpr int kModelCount = static_cast<int>(std::size(kModels));

#define FIRSTHIT_MODEL(type, text, reflects, fields, maps) , type
template <class None, class... Types>
using ModelsOfTable = std::variant<Types...>;
static_assert(
    std::is_same_v<Material::Model,
        ModelsOfTable<void FIRSTHIT_MODELS(FIRSTHIT_MODEL, FIRSTHIT_NONE, FIRSTHIT_NONE)>>,
    "Material::Model and FIRSTHIT_MODELS have the same models in the same order");
#undef FIRSTHIT_MODEL

/// Whether surfaces of a model reflect lights.
template <class Model>
inline constexpr bool kReflects = true;
/// Textures of a model; of one without, see FIRSTHIT_MODELS.
template <class Model>
inline constexpr std::span<const ModelMap> kMapsOf = {};
#define FIRSTHIT_MODEL(type, text, reflects, fields, maps)                                         \
    template <>                                                                                    \
    inline constexpr bool kReflects<type> = reflects;                                              \
    template <>                                                                                    \
    inline constexpr std::span<const ModelMap> kMapsOf<type> =                                     \
        std::span(model_table::text##_maps).first(std::size(model_table::text##_maps) - 1);
FIRSTHIT_MODELS(FIRSTHIT_MODEL, FIRSTHIT_NONE, FIRSTHIT_NONE)
#undef FIRSTHIT_MODEL
#undef FIRSTHIT_NONE

/// The number of a model's normal map, or -1.
constexpr int normal_map(std::span<const ModelMap> maps)
{
    for (std::size_t k = 0; k < maps.size(); ++k)
        if (maps[k].name == "normal_texture") return static_cast<int>(k);
    return -1;
}

/// Whether surfaces of a model reflect the environment (firsthit/environment.h).
template <class Model>
inline constexpr bool kReflectsEnvironment = std::is_same_v<Model, MetallicRoughness>;
constexpr bool reflects_environment(const ModelInfo& model)
{
    return model.type == "MetallicRoughness";
}

/// Whether the scene has an environment, and a material that reflects it.
inline bool has_reflected_environment(const Scene& scene)
{
    return scene.environment.map &&
           std::any_of(scene.materials.begin(), scene.materials.end(),
               [](const Material& m) { return reflects_environment(kModels[m.model.index()]); });
}

/// Whether the alpha of a model's texture counts. That of the others is not computed.
constexpr bool has_alpha(const ModelMap& map)
{
    return map.name == "specular_texture";
}

inline constexpr std::size_t kMostTextures = [] {
    std::size_t most = 0;
    for (const ModelInfo& model : kModels) most = std::max(most, model.maps.size());
    return most;
}();

/// A texture of a model.
template <class Model>
const TextureRef& map_of(const Model& model, const ModelMap& map)
{
    return *reinterpret_cast<const TextureRef*>(
        reinterpret_cast<const std::byte*>(&model) + map.offset);
}

/// Number of the texture of a model without maps; -1: none.
inline std::int32_t texture_number(const Material& material)
{
    return std::visit(
        [](const auto& model) {
            if constexpr (kMapsOf<std::decay_t<decltype(model)>>.empty())
                return model.texture;
            else
                return std::int32_t(-1);
        },
        material.model);
}

} // namespace firsthit
