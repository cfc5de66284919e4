// mtl_material.cpp - materials of libraries as materials of a scene.
//
// source  the roughness of an exponent: Walter, Marschner, Li, Torrance 2007, "Microfacet Models for Refraction
//         through Rough Surfaces", equation 33 (alpha = roughness squared)
#include "readers/mesh/mtl/mtl_material.h"

#include "scene/model/default_material.h"
#include "scene/model/tangents.h"

#include <glm/common.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <variant>

namespace firsthit {
namespace {

constexpr glm::mat3x2 kAsItIs{1.0f};

/// What a share of 255 steps cannot tell from 1.
constexpr float kOpaque = 0.998f;

glm::vec2 at(const glm::mat3x2& transform, const glm::vec2& uv)
{
    return transform * glm::vec3(uv, 1);
}

/// From coordinates that `first` has changed to where `map` samples the original ones. Where `first` makes all
/// one point it is not known, and nearly any answer would do.
glm::mat3x2 after(const glm::mat3x2& first, const glm::mat3x2& map)
{
    const glm::mat2 linear(first[0], first[1]);
    if (first == kAsItIs || glm::determinant(linear) == 0) return map;
    const glm::mat2 back = glm::inverse(linear);
    const glm::mat2 both = glm::mat2(map[0], map[1]) * back;
    return {both[0], both[1], map[2] - both * first[2]};
}

TextureRef reference(const MtlMap& map, std::int32_t number)
{
    return {.texture = number, .transform = map.transform()};
}

float roughness_of(float exponent)
{
    return std::pow(2 / (exponent + 2), 0.25f);
}

MetallicRoughness physical_of(const Phong& phong)
{
    MetallicRoughness made;
    made.base_color = phong.diffuse;
    made.metallic = 0;
    made.roughness = roughness_of(phong.shininess);
    return made;
}

MetallicRoughness make_physical(
    const MtlMaterial& mtl, bool has_uv, MtlTextures& textures, MtlMeshNeeds& needs)
{
    MetallicRoughness made = physical_of(mtl.phong);
    made.metallic = mtl.metallic.value_or(0.0f);
    made.roughness = mtl.roughness.value_or(made.roughness);
    made.emission = mtl.emission;
    if (!has_uv) return made;

    made.base_color_texture =
        reference(mtl.diffuse_map, textures.number(mtl.diffuse_map, Encoding::srgb));
    made.metallic_roughness_texture =
        reference(mtl.roughness_map ? mtl.roughness_map : mtl.metallic_map,
            textures.metallic_roughness(mtl.roughness_map, mtl.metallic_map));
    if (made.metallic_roughness_texture.texture >= 0) {
        if (mtl.roughness_map) made.roughness = 1;
        if (mtl.metallic_map) made.metallic = 1;
    }
    made.emission_texture =
        reference(mtl.emission_map, textures.number(mtl.emission_map, Encoding::srgb));
    if (made.emission_texture.texture >= 0 && mtl.emission == glm::vec3(0))
        made.emission = glm::vec3(1);
    made.normal_texture =
        reference(mtl.normal_map, textures.number(mtl.normal_map, Encoding::linear));
    made.normal_scale = mtl.normal_map.strength;
    needs.tangents = made.normal_texture.texture >= 0;
    needs.normal_transform = made.normal_texture.transform;
    return made;
}

Phong make_phong(const MtlMaterial& mtl, bool has_uv, MtlTextures& textures, MtlMeshNeeds& needs)
{
    Phong made = mtl.phong;
    made.ambient += mtl.emission / kMeshAmbient;
    if (has_uv) made.texture = textures.number(mtl.diffuse_map, Encoding::srgb);
    if (made.texture >= 0) needs.uv_transform = mtl.diffuse_map.transform();
    return made;
}

} // namespace

void MtlMeshNeeds::apply(Mesh& mesh) const
{
    if (uv_transform != kAsItIs)
        for (glm::vec2& uv : mesh.uv) uv = at(uv_transform, uv);
    if (tangents && !mesh.uv.empty() && !mesh.normal.empty())
        mesh.tangent = derived_tangents(mesh, mesh.uv, normal_transform);
}

Material make_material(
    const MtlMaterial& mtl, const MtlSettings& settings, MtlTextures& textures, MtlMeshNeeds& needs)
{
    Material made;
    made.name = mtl.name;
    if (settings.physical)
        made.model = make_physical(mtl, settings.has_uv, textures, needs);
    else
        made.model = make_phong(mtl, settings.has_uv, textures, needs);

    made.opacity = mtl.opacity < kOpaque ? mtl.opacity : 1.0f;
    made.alpha = made.opacity < 1 ? AlphaMode::blend : AlphaMode::opaque;
    const MtlTextures::Opacity map =
        settings.has_uv ? textures.opacity(mtl.opacity_map) : MtlTextures::Opacity{};
    if (map.number >= 0) {
        made.opacity_texture = {.texture = map.number,
            .transform = after(needs.uv_transform, mtl.opacity_map.transform())};
        if (made.alpha == AlphaMode::opaque)
            made.alpha = map.is_mask ? AlphaMode::mask : AlphaMode::blend;
    }
    return made;
}

Material make_default_material(const MtlSettings& settings)
{
    Material made = default_material();
    Phong& phong = std::get<Phong>(made.model);
    if (settings.has_colors) phong.ambient = phong.diffuse = glm::vec3(1);
    if (settings.physical) made.model = physical_of(Phong(phong));
    return made;
}

} // namespace firsthit
