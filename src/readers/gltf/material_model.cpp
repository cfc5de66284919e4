// material_model.cpp - how the materials of a glTF document reflect light.
#include "readers/gltf/scene_maker.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace firsthit::gltf {
namespace {

/// What a dielectric reflects straight back into air; 0 stands for an infinite index.
float reflectance(float ior)
{
    if (ior == 0) return 1;
    const float root = (ior - 1) / (ior + 1);
    return root * root;
}

/// The colours of one picture and the alpha of another; white and 1 where there is none.
Picture combined(const std::optional<Picture>& color, const std::optional<Picture>& alpha)
{
    Picture made;
    const Picture& size = color ? *color : *alpha;
    made.width = size.width;
    made.height = size.height;
    made.pixel.reserve(size.pixel.size());
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const auto pixel_of = [&](const Picture& of) {
                const auto column = std::int64_t(x) * of.width / size.width;
                const auto row = std::int64_t(y) * of.height / size.height;
                return of.pixel[static_cast<std::size_t>(row * of.width + column)];
            };
            made.pixel.push_back((color ? pixel_of(*color) & 0xFFFFFFu : 0xFFFFFFu) |
                                 (alpha ? pixel_of(*alpha) & 0xFF000000u : 0xFF000000u));
        }
    return made;
}

/// Roughness in green and no metal in blue, from glossiness in alpha.
Picture roughness_of(const Picture& glossy, float glossiness)
{
    Picture made = glossy;
    for (std::uint32_t& pixel : made.pixel) {
        const float gloss = glossiness * static_cast<float>(pixel >> 24);
        const auto rough = static_cast<std::uint32_t>(std::lround(255 - gloss));
        pixel = 0xFF000000u | rough << 8;
    }
    return made;
}

} // namespace

Unlit SceneMaker::unlit_of(const Material& from)
{
    return {.color = glm::vec3(from.base_color), .texture = texture_of(from.base_color_texture)};
}

MetallicRoughness SceneMaker::model_of(const Material& from)
{
    MetallicRoughness model;
    model.emission = from.emissive_strength * from.emissive;
    model.normal_scale = from.normal_scale;
    model.occlusion_strength = from.occlusion_strength;
    model.normal_texture = texture_of(from.normal_texture, Encoding::linear);
    model.occlusion_texture = texture_of(from.occlusion_texture, Encoding::linear);
    model.emission_texture = texture_of(from.emissive_texture);
    if (from.specular_glossiness) {
        add_specular_glossiness(*from.specular_glossiness, model);
        return model;
    }
    model.base_color = glm::vec3(from.base_color);
    model.metallic = from.metallic;
    model.roughness = from.roughness;
    model.f0 = glm::vec3(reflectance(from.ior.value_or(1.5f)));
    model.base_color_texture = texture_of(from.base_color_texture);
    model.metallic_roughness_texture =
        texture_of(from.metallic_roughness_texture, Encoding::linear);
    if (from.specular) add_specular(*from.specular, model);
    return model;
}

void SceneMaker::add_specular(const Specular& from, MetallicRoughness& model)
{
    model.f0 *= from.color;
    model.specular = from.factor;
    const TextureInfo& place = from.color_texture ? from.color_texture : from.texture;
    if (!place || place.tex_coord > 1) return;
    if (from.texture && from.texture.texture == from.color_texture.texture) {
        model.specular_texture = texture_of(place);
        return;
    }
    std::optional<Picture> color, alpha;
    if (from.color_texture) color = decode(from.color_texture.texture);
    if (from.texture) alpha = decode(from.texture.texture);
    model.specular_texture = place_of(place);
    if (color || alpha)
        model.specular_texture.texture =
            add_picture(place.texture, combined(color, alpha), Encoding::srgb);
}

/// f0 is the specular colour, roughness is 1 - glossiness, and there is no metal.
void SceneMaker::add_specular_glossiness(const SpecularGlossiness& from, MetallicRoughness& model)
{
    model.base_color = glm::vec3(from.diffuse);
    model.base_color_texture = texture_of(from.diffuse_texture);
    model.metallic = 0;
    model.f0 = from.specular;
    model.roughness = 1 - from.glossiness;
    const TextureInfo& glossy = from.specular_glossiness_texture;
    if (!glossy || glossy.tex_coord > 1) return;
    auto [entry, is_new] = glossy_.try_emplace({glossy.texture, from.glossiness}, -1, -1);
    if (is_new) {
        const std::optional<Picture> picture = decode(glossy.texture);
        if (!picture) return;
        entry->second = {add_picture(glossy.texture, combined(picture, {}), Encoding::srgb),
            add_picture(glossy.texture, roughness_of(*picture, from.glossiness), Encoding::linear)};
    }
    if (entry->second.first < 0) return;
    model.roughness = 1;
    model.specular_texture = model.metallic_roughness_texture = place_of(glossy);
    model.specular_texture.texture = entry->second.first;
    model.metallic_roughness_texture.texture = entry->second.second;
}

} // namespace firsthit::gltf
