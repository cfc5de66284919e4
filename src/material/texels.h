// texels.h - materials as shaders fetch them: texels of four floats.
//
// All materials have as many texels. The first one's last float is the bits of a whole number, the
// header: 256 times the texture's number, plus the model's. The fields of models.h lie in the others
// in their order, each in one texel: where the newest has no room, the next one begins.
#pragma once

#include "material/models.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace firsthit {

/// Where a field is: the texel and its float.
struct TexelPlace {
    int texel, component;
};

constexpr int kMostFields = 16; // of a model

struct ModelLayout {
    std::array<TexelPlace, kMostFields> place{}; // of each field
    int texels = 1;
};

constexpr ModelLayout model_layout(std::span<const ModelField> fields)
{
    ModelLayout layout;
    int texel = 0, next = 0; // the newest texel and its first float that is free; 3 is the header's
    for (std::size_t k = 0; k < fields.size(); ++k) {
        const int floats = fields[k].floats;
        if (next + floats > (texel == 0 ? 3 : 4)) ++texel, next = 0;
        layout.place[k] = {texel, next};
        next += floats;
    }
    layout.texels = texel + 1;
    return layout;
}

/// Of each material, whatever its model.
inline constexpr int kMaterialTexels = [] {
    int most = 0;
    for (const ModelInfo& model : kModels) most = std::max(most, model_layout(model.fields).texels);
    return most;
}();

using MaterialTexels = std::array<glm::vec4, kMaterialTexels>;

/// How the header is put together: 24 bits for the texture.
inline constexpr int kHeaderTexture = 256;

/// texture  its number; -1: none that is drawn
MaterialTexels material_texels(const Material& material, std::int32_t texture);

} // namespace firsthit
