// models.h - the table of shading models. C++ dispatch, the shaders' dispatch, a model's number and
// where its parameters lie in the shaders' buffer (texels.h) all follow from it.
//
// A new model is
//   - a struct of its parameters in include/firsthit/material.h, last in Material::Model;
//   - its formulas in src/material/NAME.glsl, which C++ and shaders compile (phong.glsl is one);
//   - its line in FIRSTHIT_MODELS, and the text's name in material/texts.inl and gl/CMakeLists.txt.
// scene/model/check_scene.cpp does not compile before it can tell whether the parameters are sound.
#pragma once

#include <firsthit/material.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>

/// MODEL(struct, text, reflects, fields)
///
/// text      its formulas are in material/text.glsl
/// reflects  whether its surfaces reflect lights: the text has `reflected`
/// fields    FIELD(struct, member) of each parameter that the formulas read: float or glm::vec3. The
///           member `texture` is not among them: every model has one
#define FIRSTHIT_MODELS(MODEL, FIELD)                                                              \
    MODEL(Phong, phong, true,                                                                      \
        FIELD(Phong, ambient) FIELD(Phong, diffuse) FIELD(Phong, specular)                         \
            FIELD(Phong, shininess))                                                               \
    MODEL(Unlit, unlit, false, FIELD(Unlit, color))

/// Before a parameter that a model has no use for; nothing in GLSL.
#define FIRSTHIT_UNUSED [[maybe_unused]]

namespace firsthit {

/// A parameter of a model.
struct ModelField {
    std::string_view name;
    std::size_t offset; // in the struct, bytes
    int floats;         // 1, or 3 for a vector
};

/// A shading model; its number is its place in the table and in Material::Model.
struct ModelInfo {
    std::string_view type; // the struct
    std::string_view text; // without .glsl
    bool reflects;
    std::span<const ModelField> fields;
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
#define FIRSTHIT_MODEL(type, text, reflects, fields) inline constexpr ModelField text[] = {fields};
FIRSTHIT_MODELS(FIRSTHIT_MODEL, FIRSTHIT_FIELD)
#undef FIRSTHIT_MODEL
#undef FIRSTHIT_FIELD

} // namespace model_table

#define FIRSTHIT_NO_FIELD(type, member)
#define FIRSTHIT_MODEL(type, text, reflects, fields) {#type, #text, reflects, model_table::text},
inline constexpr ModelInfo kModels[] = {FIRSTHIT_MODELS(FIRSTHIT_MODEL, FIRSTHIT_NO_FIELD)};
#undef FIRSTHIT_MODEL
inline constexpr int kModelCount = static_cast<int>(std::size(kModels));

#define FIRSTHIT_MODEL(type, text, reflects, fields) , type
template <class None, class... Types>
using ModelsOfTable = std::variant<Types...>;
static_assert(std::is_same_v<Material::Model,
                  ModelsOfTable<void FIRSTHIT_MODELS(FIRSTHIT_MODEL, FIRSTHIT_NO_FIELD)>>,
    "Material::Model and FIRSTHIT_MODELS have the same models in the same order");
#undef FIRSTHIT_MODEL

/// Whether surfaces of a model reflect lights.
template <class Model>
inline constexpr bool kReflects = true;
#define FIRSTHIT_MODEL(type, text, reflects, fields)                                               \
    template <>                                                                                    \
    inline constexpr bool kReflects<type> = reflects;
FIRSTHIT_MODELS(FIRSTHIT_MODEL, FIRSTHIT_NO_FIELD)
#undef FIRSTHIT_MODEL
#undef FIRSTHIT_NO_FIELD

/// Number of the texture that multiplies the material's colours; -1: none.
inline std::int32_t texture_number(const Material& material)
{
    return std::visit([](const auto& model) { return model.texture; }, material.model);
}

} // namespace firsthit
