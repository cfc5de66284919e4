// texels.cpp - materials as shaders fetch them: texels of four floats.
#include "material/texels.h"

#include <bit>
#include <cstddef>
#include <cstring>
#include <variant>

namespace firsthit {

MaterialTexels material_texels(const Material& material, std::int32_t texture)
{
    MaterialTexels texels{};
    const ModelInfo& model = kModels[material.model.index()];
    const ModelLayout layout = model_layout(model.fields);
    const auto* const parameters = std::visit(
        [](const auto& of) { return reinterpret_cast<const std::byte*>(&of); }, material.model);
    for (std::size_t k = 0; k < model.fields.size(); ++k) {
        const ModelField& field = model.fields[k];
        const TexelPlace& place = layout.place[k];
        std::memcpy(&texels[std::size_t(place.texel)][place.component], parameters + field.offset,
            sizeof(float) * std::size_t(field.floats));
    }
    const auto number = static_cast<std::int32_t>(material.model.index());
    texels[0].w = std::bit_cast<float>(kHeaderTexture * texture + number);
    return texels;
}

} // namespace firsthit
