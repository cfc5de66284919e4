// material.h - materials: shading models and their parameters.
#pragma once

#include <glm/mat3x2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <variant>

namespace firsthit {

/// Phong's model. Colours are linear Rec.709 and may exceed 1.
///
/// source  Phong 1975, "Illumination for Computer Generated Pictures"
struct Phong {
    glm::vec3 ambient{0.1f};    // times Scene::ambient
    glm::vec3 diffuse{0.8f};    // share of the light that is reflected diffusely
    glm::vec3 specular{0.0f};   // colour of highlights
    float shininess = 1.0f;     // Phong's exponent, 0 or more; negative values and NaN count as 0
    float transmittance = 0.0f; // 0 (opaque) to 1 (clear); ignored at present
    float ior = 1.0f;           // index of refraction; ignored at present
    std::int32_t texture =
        -1; // of Scene::textures; -1: none. It multiplies diffuse and ambient, as the
            // colour of the vertices does
};

/// A texture as a material uses it.
struct TextureRef {
    std::int32_t texture = -1;   // of Scene::textures; -1: none, which is white
    int uv_set = 0;              // 0: Scene::uv, 1: Scene::uv1
    glm::mat3x2 transform{1.0f}; // from texture coordinates (u, v, 1) to where it is sampled
};

/// A surface that shows its colour, whatever lights and shadows are. Its albedo is that colour.
struct Unlit {
    glm::vec3 color{1.0f}; // linear Rec.709, may exceed 1
    TextureRef texture{};  // multiplies color, as the colour of the vertices does
};

/// The model of glTF 2.0 (appendix B): a dielectric coat over a scattering base, or a metal, both with
/// microfacets. Colours are linear Rec.709. A light of irradiance E on a white matt surface that
/// it falls on straight gives E / pi.
///
/// source  Khronos 2021, "glTF 2.0 Specification", appendix B; KHR_materials_specular
struct MetallicRoughness {
    glm::vec3 base_color{1.0f}; // scattered by the base, or reflected by the metal
    float metallic = 1.0f;      // 0 dielectric to 1 metal
    float roughness = 1.0f;     // 0 to 1; its square is the width of the microfacets' slopes
    glm::vec3 emission{0.0f};   // light of its own, may exceed 1
    glm::vec3 f0{0.04f};       // share of light that a dielectric reflects straight back, at most 1
    float specular = 1.0f;     // of a dielectric: multiplies f0, and is the share at grazing angles
    float normal_scale = 1.0f; // multiplies x and y of normal_texture
    float occlusion_strength = 1.0f; // 0: occlusion_texture does nothing
    TextureRef base_color_texture{}; // multiplies base_color, as the colour of the vertices does
    TextureRef metallic_roughness_texture{}; // green multiplies roughness, blue metallic
    TextureRef normal_texture{}; // 0 to 1 are -1 to 1: x along the tangent, y along the bitangent
    TextureRef occlusion_texture{}; // red is the share of ambient light that arrives
    TextureRef emission_texture{};  // multiplies emission
    TextureRef specular_texture{};  // colour multiplies f0, alpha multiplies specular
};

/// What a surface's opacity does: the product of Material::opacity, the alpha of the vertex colour and the
/// alpha of Material::opacity_texture, always of its largest level.
enum class AlphaMode {
    opaque, // nothing: hits and shadows do not know it
    mask,   // the surface is where its opacity is at least alpha_cutoff, and nowhere else
    blend,  // what lies behind shines through
};

/// A material: one of several shading models, and what all models have in common.
struct Material {
    using Model =
        std::variant<Phong, Unlit, MetallicRoughness>; // as src/material/models.h has them

    std::string name;                    // as the file has it
    AlphaMode alpha = AlphaMode::opaque; // what its opacity does
    float alpha_cutoff = 0.5f;           // of AlphaMode::mask
    float opacity = 1.0f;                // 0 to 1
    TextureRef opacity_texture{};        // of which the alpha counts
    bool double_sided = true;            // as the file has it; both sides are always seen
    Model model;                         // how it reflects light
};

} // namespace firsthit
