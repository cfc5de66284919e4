// materials.cpp - the materials and textures of a glTF document.
#include "readers/gltf/data/images.h"
#include "readers/gltf/scene_maker.h"
#include "scene/model/tangents.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace firsthit::gltf {
namespace {

firsthit::Wrap wrap_of(Wrap wrap)
{
    switch (wrap) {
    case Wrap::kClampToEdge:
        return firsthit::Wrap::clamp;
    case Wrap::kMirroredRepeat:
        return firsthit::Wrap::mirror;
    case Wrap::kRepeat:
        break;
    }
    return firsthit::Wrap::repeat;
}

/// KHR_texture_transform, where v counts from a picture's bottom: 1 - v is what the extension moves.
/// The rotation goes the way of the sample model TextureTransformTest and of Khronos' viewer.
glm::mat3x2 transform_of(const TextureInfo& info)
{
    const float c = std::cos(info.rotation_rad), s = std::sin(info.rotation_rad);
    const glm::vec2 per_u(c * info.scale.x, -s * info.scale.x);
    const glm::vec2 per_v(s * info.scale.y, c * info.scale.y);
    return {per_u.x, -per_u.y, -per_v.x, per_v.y, per_v.x + info.offset.x,
        (1 - per_v.y) - info.offset.y};
}

} // namespace

std::uint32_t SceneMaker::material_of(int number)
{
    // The default material of primitives that name none is the last.
    std::int32_t& known =
        material_[number == kNone ? document_.materials.size() : static_cast<std::size_t>(number)];
    if (known >= 0) return static_cast<std::uint32_t>(known);
    const Material standard;
    const Material& from =
        number == kNone ? standard : document_.materials[static_cast<std::size_t>(number)];
    warn_of_missing(from);
    firsthit::Material made;
    made.name = number == kNone ? "default" : from.name;
    made.double_sided = from.double_sided;
    made.alpha = from.alpha_mode == AlphaMode::kMask    ? firsthit::AlphaMode::mask
                 : from.alpha_mode == AlphaMode::kBlend ? firsthit::AlphaMode::blend
                                                        : firsthit::AlphaMode::opaque;
    made.alpha_cutoff = from.alpha_cutoff;
    const auto& old = from.specular_glossiness;
    made.opacity = old && !from.unlit ? old->diffuse.a : from.base_color.a;
    made.opacity_texture =
        texture_of(old && !from.unlit ? old->diffuse_texture : from.base_color_texture);
    if (from.unlit)
        made.model = unlit_of(from);
    else
        made.model = model_of(from);
    known = static_cast<std::int32_t>(builder_.add_material(std::move(made)));
    return static_cast<std::uint32_t>(known);
}

void SceneMaker::warn_of_missing(const Material& material)
{
    const auto warn = [&](bool has, const char* extension, const char* effect) {
        if (has)
            warn_once(
                fmt::format("{}: {} is not drawn yet: {}", document_.name, extension, effect));
    };
    const bool transmits = material.transmission && material.transmission->factor > 0;
    warn(transmits, "KHR_materials_transmission", "surfaces are not clear");
    warn(transmits && material.volume, "KHR_materials_volume", "nothing is refracted or absorbed");
    warn(material.clearcoat && material.clearcoat->factor > 0, "KHR_materials_clearcoat",
        "coats are left out");
    warn(material.sheen && material.sheen->color != glm::vec3(0), "KHR_materials_sheen",
        "sheen is left out");
}

TextureRef SceneMaker::texture_of(const TextureInfo& info, Encoding encoding)
{
    TextureRef made = place_of(info);
    if (info && info.tex_coord <= 1) made.texture = add_texture(info.texture, encoding);
    return made;
}

/// Where a texture is sampled; which one is not said yet.
TextureRef SceneMaker::place_of(const TextureInfo& info)
{
    if (!info) return {};
    if (info.tex_coord > 1) {
        warn_once(
            fmt::format("{}: only TEXCOORD_0 and TEXCOORD_1 are read: textures at TEXCOORD_{} "
                        "are not shown",
                document_.name, info.tex_coord));
        return {};
    }
    TextureRef made;
    made.uv_set = info.tex_coord;
    made.transform = transform_of(info);
    return made;
}

std::int32_t SceneMaker::add_texture(int number, Encoding encoding)
{
    const Texture& texture = document_.textures[static_cast<std::size_t>(number)];
    if (texture.image == kNone) return -1;
    const Sampler& sampler = texture.sampler;
    const bool nearest = sampler.mag_filter == Filter::kNearest;
    const auto [entry, is_new] = texture_.try_emplace(
        {texture.image, sampler.wrap_s, sampler.wrap_t, nearest, encoding}, -1);
    if (!is_new) return entry->second;
    const std::optional<Picture> picture = decode(number);
    if (picture) entry->second = add_picture(number, *picture, encoding);
    return entry->second;
}

std::optional<Picture> SceneMaker::decode(int number)
{
    const Texture& texture = document_.textures[static_cast<std::size_t>(number)];
    if (texture.image == kNone) return {};
    DecodedImage image = decode_image(document_, texture.image);
    if (!image.picture) warn_once(image.why_not);
    return std::move(image.picture);
}

/// A picture in the place of a texture's, sampled as that is.
std::int32_t SceneMaker::add_picture(int number, const Picture& picture, Encoding encoding)
{
    const Texture& texture = document_.textures[static_cast<std::size_t>(number)];
    firsthit::Texture made(image_name(document_, texture.image), picture, encoding);
    made.set_sampler({.wrap_u = wrap_of(texture.sampler.wrap_s),
        .wrap_v = wrap_of(texture.sampler.wrap_t),
        .nearest = texture.sampler.mag_filter == Filter::kNearest});
    return static_cast<std::int32_t>(builder_.add_texture(std::move(made)));
}

/// Tangents for a normal map, where the file has none.
void SceneMaker::add_tangents(const Primitive& primitive, firsthit::Mesh& mesh)
{
    if (primitive.material == kNone || !mesh.tangent.empty()) return;
    const Material& material = document_.materials[static_cast<std::size_t>(primitive.material)];
    if (material.unlit || !material.normal_texture) return;
    const std::vector<glm::vec2>& uv = material.normal_texture.tex_coord == 0 ? mesh.uv : mesh.uv1;
    if (material.normal_texture.tex_coord <= 1 && !uv.empty())
        mesh.tangent = derived_tangents(mesh, uv, transform_of(material.normal_texture));
}

} // namespace firsthit::gltf
