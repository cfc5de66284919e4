// texels.h - packs materials into texels of four floats, as shaders load them.
//
// Every material has the same number of texels. The last float of the first texel holds the bits of
// an integer, the header: 256 * the texture's number + the model's number. The fields of models.h
// follow in order. A field never crosses texels: if the current texel has no room, the field starts
// the next. Behind the texels of the model with the most fields, each map has two texels:
//
//     per_u.x, per_u.y, per_v.x, per_v.y     it is sampled at per_u * u + per_v * v + offset
//     offset.x, offset.y, texture, uv_set    bits of integers; texture -1: none that is drawn
#pragma once

#include "material/models.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <span>

namespace firsthit {

/// The position of a field: its texel, and its first float in the texel (0 to 3).
struct TexelComponent {
    int texel, component;
};

constexpr int kMostFields = 16; // most fields of a model

struct ModelLayout {
    std::array<TexelComponent, kMostFields> field{}; // where each field is
    int texels = 1;
};

constexpr ModelLayout model_layout(std::span<const ModelField> fields)
{
    ModelLayout layout;
    int texel = 0, next = 0; // the current texel, and its first free float
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const int floats = fields[k].floats;
        if (next + floats > (texel == 0 ? 3 : 4)) ++texel, next = 0;
        layout.field[k] = {texel, next};
        next += floats;
    }
    layout.texels = texel + 1;
    return layout;
}

/// The number of the first map's first texel in each material, whatever its model.
inline constexpr int kFirstMapTexel = [] {
    int most = 0;
    for (const ModelInfo& model : kModels) most = std::max(most, model_layout(model.fields).texels);
    return most;
}();
inline constexpr int kMapTexels = 2; // of each map

/// Of each material.
inline constexpr int kMaterialTexels = kFirstMapTexel + kMapTexels * int(kMostTextures);

using MaterialTexels = std::array<glm::vec4, kMaterialTexels>;

/// The factor of the texture's number in the header. Leaves 24 bits for that number.
inline constexpr int kHeaderTexture = 256;

/// Returns the texels of a material.
/// texture   the number of the texture of a model without maps; -1: none, or one without texels
/// is_drawn  whether a map of the material's model has a texture that is drawn
MaterialTexels material_texels(const Material& material, std::int32_t texture,
    const std::function<bool(const TextureRef&)>& is_drawn);

} // namespace firsthit
