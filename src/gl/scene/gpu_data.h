// gpu_data.h - layouts.glsl as C++: the structs that the gpu engine's shaders read, and their fields.
#pragma once

#include "exact/rays.h"

#include <firsthit/scene.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace firsthit::gl {

#define FIRSTHIT_CONSTANT(type, name, value) inline constexpr type name = type(value);
#define FIRSTHIT_STRUCT(name)                                                                      \
    struct name {                                                                                  \
        using vec3 = glm::vec3;                                                                    \
        using ivec2 = glm::ivec2;                                                                  \
        using uint = std::uint32_t;
#define FIRSTHIT_FIELD(type, name, value) type name{value};
#define FIRSTHIT_NESTED(type, name) type name{};
#define FIRSTHIT_HAS_RAYS
#define FIRSTHIT_END(name)                                                                         \
    }                                                                                              \
    ;
#include "gl/layouts.glsl"
#undef FIRSTHIT_CONSTANT
#undef FIRSTHIT_STRUCT
#undef FIRSTHIT_FIELD
#undef FIRSTHIT_NESTED
#undef FIRSTHIT_END
#undef FIRSTHIT_HAS_RAYS

/// A field of a struct, as C++ has it.
struct LayoutField {
    std::string_view type; // in GLSL
    std::string_view name;
    std::size_t offset, size; // bytes
};

/// How std140 and std430 align a type; a struct that is nested has a vec3.
constexpr std::size_t std140_alignment(std::string_view type)
{
    return type == "float" || type == "int" || type == "uint" ? 4 : type == "ivec2" ? 8 : 16;
}

/// Whether C++ has put the fields where std140 and std430 have them.
constexpr bool is_std140(std::span<const LayoutField> fields, std::size_t size)
{
    const auto round_up = [](std::size_t x, std::size_t to) { return (x + to - 1) / to * to; };
    std::size_t end = 0;
    for (const LayoutField& field : fields) {
        if (field.offset != round_up(end, std140_alignment(field.type))) return false;
        end = field.offset + field.size;
    }
    return size == round_up(end, 16);
}

/// LayoutOf<FrameData>::kFields: a table of the struct's fields.
template <class Struct>
struct LayoutOf;

#define FIRSTHIT_CONSTANT(type, name, value)
#define FIRSTHIT_STRUCT(name)                                                                      \
    template <>                                                                                    \
    struct LayoutOf<name> {                                                                        \
        using Struct = name;                                                                       \
        static constexpr LayoutField kFields[] = {
#define FIRSTHIT_FIELD(type, name, value)                                                          \
    {#type, #name, offsetof(Struct, name), sizeof(Struct::name)},
#define FIRSTHIT_NESTED(type, name) FIRSTHIT_FIELD(type, name, )
#define FIRSTHIT_END(name)                                                                         \
    }                                                                                              \
    ;                                                                                              \
    }                                                                                              \
    ;                                                                                              \
    static_assert(is_std140(LayoutOf<name>::kFields, sizeof(name)));
#include "gl/layouts.glsl"
#undef FIRSTHIT_CONSTANT
#undef FIRSTHIT_STRUCT
#undef FIRSTHIT_FIELD
#undef FIRSTHIT_NESTED
#undef FIRSTHIT_END

static_assert(kPointLight == int(Light::Kind::point) && kSpotLight == int(Light::Kind::spot) &&
              kDirectionalLight == int(Light::Kind::directional));

/// At most so many lights lie in uniform blocks, of which every driver has 16 KB; more in storage
/// blocks, which are slower.
inline constexpr std::size_t kFewLights = 28;
static_assert(kFewLights * sizeof(LightData) <= 16384);

} // namespace firsthit::gl
