// texels.cpp - packs materials into texels of four floats, as shaders load them.
#include "material/texels.h"

#include <bit>
#include <cstddef>
#include <cstring>
#include <variant>

namespace firsthit {

namespace {

void put_map(const TextureRef& map, bool is_drawn, glm::vec4* texel)
{
    const glm::mat3x2& m = map.transform;
    const auto bits = [](std::int32_t number) { return std::bit_cast<float>(number); };
    texel[0] = {m[0].x, m[0].y, m[1].x, m[1].y};
    texel[1] = {m[2].x, m[2].y, bits(is_drawn ? map.texture : -1), bits(map.uv_set)};
}

} // namespace

MaterialTexels material_texels(const Material& material, std::int32_t texture,
    const std::function<bool(const TextureRef&)>& is_drawn)
{
    MaterialTexels texels{};
    const ModelInfo& model = kModels[material.model.index()];
    const ModelLayout layout = model_layout(model.fields);
    const auto* const parameters = std::visit(
        [](const auto& of) { return reinterpret_cast<const std::byte*>(&of); }, material.model);
    for (std::size_t k = 0; k < model.fields.size(); ++k) {
        const ModelField& field = model.fields[k];
        const TexelComponent& at = layout.field[k];
        std::memcpy(&texels[std::size_t(at.texel)][at.component], parameters + field.offset,
            sizeof(float) * std::size_t(field.floats));
    }
    for (std::size_t k = 0; k < model.maps.size(); ++k) {
        TextureRef map;
        std::memcpy(&map, parameters + model.maps[k].offset, sizeof map);
        put_map(map, is_drawn(map), &texels[std::size_t(kFirstMapTexel) + kMapTexels * k]);
    }
    const auto number = static_cast<std::int32_t>(material.model.index());
    texels[0].w = std::bit_cast<float>(kHeaderTexture * texture + number);
    return texels;
}

} // namespace firsthit
