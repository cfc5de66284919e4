// material.h - what a glTF document says about surfaces: materials, textures, samplers, images.
#pragma once

#include "readers/gltf/data/accessor.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <memory>
#include <optional>
#include <string>

namespace firsthit::gltf {

/// A texture as a material uses it.
struct TextureInfo {
    int texture = kNone;
    int tex_coord = 0; // TEXCOORD_n; the one of KHR_texture_transform where it names one
    // KHR_texture_transform: uv' = offset + R(rotation) (scale * uv), before sampling.
    glm::vec2 offset{0.0f};
    float rotation_rad = 0.0f; // counter-clockwise in the picture, as the extension has it
    glm::vec2 scale{1.0f};

    explicit operator bool() const { return texture != kNone; }
};

enum class AlphaMode { kOpaque, kMask, kBlend };

/// KHR_materials_specular.
struct Specular {
    float factor = 1.0f;
    TextureInfo texture; // alpha
    glm::vec3 color{1.0f};
    TextureInfo color_texture; // RGB, sRGB
};

/// KHR_materials_pbrSpecularGlossiness; it stands in place of base colour, metallic and roughness.
struct SpecularGlossiness {
    glm::vec4 diffuse{1.0f};
    TextureInfo diffuse_texture; // RGBA, sRGB
    glm::vec3 specular{1.0f};
    float glossiness = 1.0f;
    TextureInfo specular_glossiness_texture; // RGB sRGB, glossiness in alpha
};

/// KHR_materials_transmission.
struct Transmission {
    float factor = 0.0f;
    TextureInfo texture; // red
};

/// KHR_materials_volume.
struct Volume {
    float thickness = 0.0f;            // 0: thin-walled
    TextureInfo thickness_texture;     // green
    float attenuation_distance = 0.0f; // 0: infinite, nothing is absorbed
    glm::vec3 attenuation_color{1.0f};
};

/// KHR_materials_clearcoat.
struct Clearcoat {
    float factor = 0.0f;
    TextureInfo texture; // red
    float roughness = 0.0f;
    TextureInfo roughness_texture; // green
    TextureInfo normal_texture;
    float normal_scale = 1.0f;
};

/// KHR_materials_sheen.
struct Sheen {
    glm::vec3 color{0.0f};
    TextureInfo color_texture; // RGB, sRGB
    float roughness = 0.0f;
    TextureInfo roughness_texture; // alpha
};

/// A value of this type without changes is the default material of primitives that name none.
struct Material {
    std::string name;
    glm::vec4 base_color{1.0f};
    TextureInfo base_color_texture; // RGBA, sRGB
    float metallic = 1.0f;
    float roughness = 1.0f;
    TextureInfo metallic_roughness_texture; // metallic in blue, roughness in green
    TextureInfo normal_texture;
    float normal_scale = 1.0f;
    TextureInfo occlusion_texture; // red
    float occlusion_strength = 1.0f;
    glm::vec3 emissive{0.0f};
    TextureInfo emissive_texture; // RGB, sRGB
    AlphaMode alpha_mode = AlphaMode::kOpaque;
    float alpha_cutoff = 0.5f; // of kMask
    bool double_sided = false;

    bool unlit = false;             // KHR_materials_unlit
    float emissive_strength = 1.0f; // KHR_materials_emissive_strength
    std::optional<float> ior;       // KHR_materials_ior; 1.5 where it says nothing, 0 is infinite
    std::optional<Specular> specular;
    std::optional<SpecularGlossiness> specular_glossiness;
    std::optional<Transmission> transmission;
    std::optional<Volume> volume;
    std::optional<Clearcoat> clearcoat;
    std::optional<Sheen> sheen;
};

enum class Wrap { kClampToEdge = 33071, kMirroredRepeat = 33648, kRepeat = 10497 };

/// The file's own codes; kUnset leaves the choice to the renderer.
enum class Filter {
    kUnset = 0,
    kNearest = 9728,
    kLinear = 9729,
    kNearestMipmapNearest = 9984,
    kLinearMipmapNearest = 9985,
    kNearestMipmapLinear = 9986,
    kLinearMipmapLinear = 9987,
};

struct Sampler {
    Wrap wrap_s = Wrap::kRepeat;
    Wrap wrap_t = Wrap::kRepeat;
    Filter mag_filter = Filter::kUnset; // kNearest or kLinear
    Filter min_filter = Filter::kUnset;
};

struct Texture {
    std::string name;
    Sampler sampler; // the one that it names, or the default
    /// The image to show: EXT_texture_webp's where there is one and WebP can be read, else `source`,
    /// else KHR_texture_basisu's, which cannot be decoded. May be none.
    int image = kNone;
};

struct Image {
    std::string name;
    std::string uri;       // decoded; empty where it is a buffer view or a data URI
    std::string path;      // of its file, if it has one
    std::string mime_type; // as the document has it; may be wrong or empty
    int buffer_view = kNone;
    std::shared_ptr<const std::string> data; // of a data URI
    std::string missing;                     // why it has no bytes, for messages
};

} // namespace firsthit::gltf
