// gpu_data.h - layouts.glsl and pose_layout.glsl as C++: the structs that shaders read, and tables
// of their fields, by which the compiler checks that each field is where GLSL expects it.
#pragma once

#include "exact/rays.h"

#include <firsthit/scene.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace firsthit::gl {

#define FIRSTHIT_CONSTANT(type, name, value) inline constexpr type name = type(value);
#define FIRSTHIT_STRUCT(name)                                                                      \
    struct name {                                                                                  \
        using vec3 = glm::vec3;                                                                    \
        using vec4 = glm::vec4;                                                                    \
        using ivec2 = glm::ivec2;                                                                  \
        using uint = std::uint32_t;
#define FIRSTHIT_FIELD(type, name, value) type name{value};
#define FIRSTHIT_NESTED(type, name) type name{};
#define FIRSTHIT_ARRAY(type, name, count) type name[count]{};
#define FIRSTHIT_HAS_RAYS
#define FIRSTHIT_END(name)                                                                         \
    }                                                                                              \
    ;
#include "gl/layouts.glsl"
#include "gl/pose_layout.glsl"
#undef FIRSTHIT_CONSTANT
#undef FIRSTHIT_STRUCT
#undef FIRSTHIT_FIELD
#undef FIRSTHIT_NESTED
#undef FIRSTHIT_ARRAY
#undef FIRSTHIT_END
#undef FIRSTHIT_HAS_RAYS

/// A field of a struct, as C++ has it.
struct LayoutField {
    std::string_view type; // in GLSL; of one element where the field is an array
    std::string_view name;
    std::size_t offset, size; // bytes
    bool is_array;
};

/// The alignment, in bytes, that std140 and std430 give a type. Structs that are nested have a
/// vec3, and arrays have elements of 16 bytes.
constexpr std::size_t glsl_alignment(std::string_view type)
{
    return type == "float" || type == "int" || type == "uint" ? 4 : type == "ivec2" ? 8 : 16;
}

constexpr std::size_t glsl_alignment(std::span<const LayoutField> fields)
{
    std::size_t most = 0;
    for (const LayoutField& field : fields) most = std::max(most, glsl_alignment(field.type));
    return most;
}

/// Whether a struct of `size` bytes and its fields lie in C++ as std430 lays them out. A struct
/// that is aligned to 16 bytes then lies as std140 does, too.
constexpr bool is_std430(std::span<const LayoutField> fields, std::size_t size)
{
    const auto round_up = [](std::size_t x, std::size_t to) { return (x + to - 1) / to * to; };
    std::size_t end = 0;
    for (const LayoutField& field : fields) {
        if (field.is_array && glsl_alignment(field.type) != 16) return false;
        if (field.offset != round_up(end, glsl_alignment(field.type))) return false;
        end = field.offset + field.size;
    }
    return size == round_up(end, glsl_alignment(fields));
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
    {#type, #name, offsetof(Struct, name), sizeof(Struct::name), false},
#define FIRSTHIT_NESTED(type, name) FIRSTHIT_FIELD(type, name, )
#define FIRSTHIT_ARRAY(type, name, count)                                                          \
    {#type, #name, offsetof(Struct, name), sizeof(Struct::name), true},
#define FIRSTHIT_END(name)                                                                         \
    }                                                                                              \
    ;                                                                                              \
    }                                                                                              \
    ;                                                                                              \
    static_assert(is_std430(LayoutOf<name>::kFields, sizeof(name)));
#include "gl/layouts.glsl"
#include "gl/pose_layout.glsl"
#undef FIRSTHIT_CONSTANT
#undef FIRSTHIT_STRUCT
#undef FIRSTHIT_FIELD
#undef FIRSTHIT_NESTED
#undef FIRSTHIT_ARRAY
#undef FIRSTHIT_END

// These lie in uniform blocks, by std140.
static_assert(glsl_alignment(LayoutOf<FrameData>::kFields) == 16 &&
              glsl_alignment(LayoutOf<LightData>::kFields) == 16 &&
              glsl_alignment(LayoutOf<MapData>::kFields) == 16);
static_assert(kPointLight == int(Light::Kind::point) && kSpotLight == int(Light::Kind::spot) &&
              kDirectionalLight == int(Light::Kind::directional));

/// Up to this number of lights, the lights and their maps are read from uniform blocks, for which
/// every driver has at least 16 KB. More lights are read from storage blocks, which are slower.
inline constexpr std::size_t kFewLights = 28;
static_assert(kFewLights * sizeof(LightData) <= 16384);

} // namespace firsthit::gl
