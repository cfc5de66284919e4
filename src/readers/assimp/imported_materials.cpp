// imported_materials.cpp - the materials of what Assimp has read.
#include "readers/assimp/imported_materials.h"

#include "readers/assimp/convert.h"
#include "scene/model/default_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace firsthit {
namespace {

/// A finite number of a material; nothing where it has none.
std::optional<float> number_of(
    const aiMaterial& from, const char* key, unsigned type, unsigned index)
{
    float value = 0;
    if (from.Get(key, type, index, value) != aiReturn_SUCCESS || !std::isfinite(value)) return {};
    return value;
}

std::optional<glm::vec3> color_of(
    const aiMaterial& from, const char* key, unsigned type, unsigned index)
{
    aiColor3D value;
    if (from.Get(key, type, index, value) != aiReturn_SUCCESS) return {};
    const glm::vec3 color = vector_of(value);
    if (!std::isfinite(color.r + color.g + color.b)) return {};
    return glm::vec3(std::max(0.0f, color.r), std::max(0.0f, color.g), std::max(0.0f, color.b));
}

bool has(const aiMaterial& from, aiTextureType type)
{
    return from.GetTextureCount(type) > 0;
}

float share(float x)
{
    return std::clamp(x, 0.0f, 1.0f);
}

} // namespace

ImportedMaterials::ImportedMaterials(
    const aiScene& from, std::string name, std::filesystem::path folder, SceneBuilder& builder)
    : from_(from),
      name_(std::move(name)),
      folder_(std::move(folder)),
      builder_(builder),
      normal_(from.mNumMaterials)
{
}

void ImportedMaterials::add_all()
{
    for (unsigned m = 0; m < from_.mNumMaterials; ++m) {
        Material made = material_of(*from_.mMaterials[m]);
        if (const auto* model = std::get_if<MetallicRoughness>(&made.model))
            normal_[m] = model->normal_texture;
        physical_ = physical_ || std::holds_alternative<MetallicRoughness>(made.model);
        number_.push_back(builder_.add_material(std::move(made)));
    }
    number_.push_back(builder_.add_material(default_material()));
}

std::uint32_t ImportedMaterials::number(unsigned material) const
{
    return number_[std::min<std::size_t>(material, number_.size() - 1)];
}

TextureRef ImportedMaterials::normal_texture(unsigned material) const
{
    return material < normal_.size() ? normal_[material] : TextureRef{};
}

Material ImportedMaterials::material_of(const aiMaterial& from)
{
    Material made;
    aiString name;
    if (from.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS) made.name = name.C_Str();
    int mode = 0;
    from.Get(AI_MATKEY_SHADING_MODEL, mode);
    // A roughness alone says little: Assimp makes one of every Phong exponent of FBX.
    const bool physical =
        number_of(from, AI_MATKEY_METALLIC_FACTOR) || color_of(from, AI_MATKEY_BASE_COLOR) ||
        mode == aiShadingMode_PBR_BRDF || has(from, aiTextureType_BASE_COLOR) ||
        has(from, aiTextureType_METALNESS) || has(from, aiTextureType_DIFFUSE_ROUGHNESS);
    if (physical)
        made.model = metallic_roughness_of(from);
    else if (mode == aiShadingMode_NoShading)
        made.model = Unlit{.color = color_of(from, AI_MATKEY_COLOR_DIFFUSE).value_or(glm::vec3(1)),
            .texture = texture_of(from, aiTextureType_DIFFUSE, Use::color)};
    else
        made.model = phong_of(from);
    set_opacity(from, made);
    return made;
}

MetallicRoughness ImportedMaterials::metallic_roughness_of(const aiMaterial& from)
{
    MetallicRoughness made;
    const auto base = color_of(from, AI_MATKEY_BASE_COLOR);
    made.base_color = base ? *base : color_of(from, AI_MATKEY_COLOR_DIFFUSE).value_or(glm::vec3(1));
    made.metallic = share(number_of(from, AI_MATKEY_METALLIC_FACTOR).value_or(0));
    made.roughness = share(number_of(from, AI_MATKEY_ROUGHNESS_FACTOR).value_or(1));
    made.emission = color_of(from, AI_MATKEY_COLOR_EMISSIVE).value_or(glm::vec3(0)) *
                    std::max(0.0f, number_of(from, AI_MATKEY_EMISSIVE_INTENSITY).value_or(1));
    made.base_color_texture = texture_of(from,
        has(from, aiTextureType_BASE_COLOR) ? aiTextureType_BASE_COLOR : aiTextureType_DIFFUSE,
        Use::color);
    made.normal_texture = texture_of(from, aiTextureType_NORMALS, Use::data);
    made.emission_texture = texture_of(from,
        has(from, aiTextureType_EMISSION_COLOR) ? aiTextureType_EMISSION_COLOR
                                                : aiTextureType_EMISSIVE,
        Use::color);
    if (made.emission_texture.texture >= 0 && made.emission == glm::vec3(0))
        made.emission = glm::vec3(1);
    made.occlusion_texture = texture_of(from, aiTextureType_AMBIENT_OCCLUSION, Use::data);
    // One texture has both; of two pictures only that of the roughness is shown.
    if (has(from, aiTextureType_DIFFUSE_ROUGHNESS)) {
        made.metallic_roughness_texture =
            texture_of(from, aiTextureType_DIFFUSE_ROUGHNESS, Use::roughness);
        if (has(from, aiTextureType_METALNESS))
            warn_once(fmt::format("{}: textures of metalness beside those of roughness are not "
                                  "shown",
                name_));
    } else {
        made.metallic_roughness_texture = texture_of(from, aiTextureType_METALNESS, Use::metallic);
        if (made.metallic_roughness_texture.texture >= 0 && made.metallic == 0) made.metallic = 1;
    }
    return made;
}

Phong ImportedMaterials::phong_of(const aiMaterial& from)
{
    Phong made;
    made.diffuse = color_of(from, AI_MATKEY_COLOR_DIFFUSE).value_or(made.diffuse);
    made.texture = texture_of(from, aiTextureType_DIFFUSE, Use::color).texture;
    // Ambient colours of such files are often black, and mean no more than that nobody set them.
    made.ambient = made.diffuse;
    made.shininess = number_of(from, AI_MATKEY_SHININESS).value_or(0);
    if (made.shininess > 0)
        made.specular = color_of(from, AI_MATKEY_COLOR_SPECULAR).value_or(glm::vec3(0)) *
                        std::max(0.0f, number_of(from, AI_MATKEY_SHININESS_STRENGTH).value_or(1));
    made.ior = number_of(from, AI_MATKEY_REFRACTI).value_or(made.ior);
    if (has(from, aiTextureType_NORMALS) || has(from, aiTextureType_HEIGHT))
        warn_once(
            fmt::format("{}: normal and height maps of Phong materials are not shown", name_));
    return made;
}

void ImportedMaterials::set_opacity(const aiMaterial& from, Material& made)
{
    const float opacity = share(number_of(from, AI_MATKEY_OPACITY).value_or(1));
    if (opacity <= 0)
        // Exporters and readers do not agree about which end of the scale is clear.
        warn_once(fmt::format(
            "{}: material '{}' has no opacity at all: it is shown as opaque", name_, made.name));
    else if (opacity < 1) {
        made.alpha = AlphaMode::blend;
        made.opacity = opacity;
    }
    if (!has(from, aiTextureType_OPACITY)) return;
    made.opacity_texture = texture_of(from, aiTextureType_OPACITY, Use::opacity);
    if (made.opacity_texture.texture >= 0) made.alpha = AlphaMode::blend;
}

void ImportedMaterials::warn_once(const std::string& warning)
{
    if (warned_.insert(warning).second) builder_.warn(warning);
}

} // namespace firsthit
