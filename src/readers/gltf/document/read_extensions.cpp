// read_extensions.cpp - which extensions a glTF document uses, and what is lost without them.
#include "readers/gltf/data/draco.h"
#include "readers/gltf/document/loader.h"
#include "readers/gltf/data/meshopt.h"
#include "readers/image/webp.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace firsthit::gltf {
namespace {

constexpr std::array<std::string_view, 21> kSupported = {"EXT_mesh_gpu_instancing",
    "EXT_meshopt_compression", "EXT_texture_webp", "KHR_draco_mesh_compression",
    "KHR_lights_punctual", "KHR_materials_clearcoat", "KHR_materials_emissive_strength",
    "KHR_materials_ior", "KHR_materials_pbrSpecularGlossiness", "KHR_materials_sheen",
    "KHR_materials_specular", "KHR_materials_transmission", "KHR_materials_unlit",
    "KHR_materials_variants", "KHR_materials_volume", "KHR_mesh_quantization",
    "KHR_meshopt_compression", "KHR_texture_transform",
    // They do not change what is seen.
    "FB_ngon_encoding", "KHR_xmp", "KHR_xmp_json_ld"};

struct Unsupported {
    std::string_view name;
    std::string_view effect;
    bool only_textures = false; // without it, only pictures are missing
};

constexpr std::array<Unsupported, 16> kUnsupported = {{
    {"EXT_lights_ies", "lights shine evenly"},
    {"EXT_lights_image_based", "the environment is not shown"},
    {"EXT_texture_avif", "AVIF textures are not shown", true},
    {"GOOGLE_texture_basis", "textures in Basis Universal are not shown", true},
    {"KHR_animation_pointer",
        "only translations, rotations, scales and weights of nodes are animated"},
    {"KHR_audio", "there is no sound"},
    {"KHR_materials_anisotropy", "highlights are round"},
    {"KHR_materials_diffuse_transmission", "no light shines through surfaces diffusely"},
    {"KHR_materials_dispersion", "all colours are refracted alike"},
    {"KHR_materials_iridescence", "thin films have no colours"},
    {"KHR_node_visibility", "hidden nodes are shown"},
    {"KHR_texture_basisu", "textures in KTX2 (Basis Universal) are not shown", true},
    {"KHR_texture_ktx", "textures in KTX2 are not shown", true},
    {"MSFT_lod", "only the finest level of detail is shown"},
    {"MSFT_texture_dds", "DDS textures are not shown", true},
    {"VRM", "only what glTF itself describes is shown"},
}};

const Unsupported* find_unsupported(std::string_view name)
{
    const auto found = std::find_if(kUnsupported.begin(), kUnsupported.end(),
        [&](const Unsupported& known) { return known.name == name; });
    return found == kUnsupported.end() ? nullptr : &*found;
}

bool is_supported(std::string_view name)
{
    return std::find(kSupported.begin(), kSupported.end(), name) != kSupported.end();
}

std::vector<std::string> names(Loader& loader, const Place& place, const char* key)
{
    std::vector<std::string> list;
    const auto found = place.json().find(key);
    if (found == place.json().end()) return list;
    if (!found->is_array())
        place.fail(key, fmt::format("an array was expected, not {}", found->type_name()));
    constexpr std::size_t kMost = 1000;
    if (found->size() > kMost)
        place.fail(key, fmt::format("{} names, at most {} are accepted", found->size(), kMost));
    for (const Json& name : *found) {
        if (!name.is_string())
            place.fail(key, fmt::format("a text was expected, not {}", name.type_name()));
        list.push_back(name.get<std::string>());
        if (std::count(list.begin(), list.end(), list.back()) > 1)
            loader.warn("extension twice", fmt::format("{} names '{}' twice", key, list.back()));
    }
    return list;
}

void check_required(Loader& loader, const std::string& name)
{
    const auto& used = loader.document.extensions_used;
    if (std::find(used.begin(), used.end(), name) == used.end()) {
        loader.warn("required " + name,
            fmt::format(
                "the extension '{}' is in extensionsRequired, but not in extensionsUsed", name));
        loader.document.extensions_used.push_back(name);
    }
    if (is_supported(name)) {
        if (name.ends_with("meshopt_compression") && !can_unpack_meshopt())
            loader.root.fail("", kNoMeshopt);
        if (name == "KHR_draco_mesh_compression" && !can_decode_draco())
            loader.root.fail("", kNoDraco);
        return;
    }
    const Unsupported* const known = find_unsupported(name);
    if (!known || !known->only_textures)
        loader.root.fail(
            "extensionsRequired", fmt::format("the extension '{}' is not supported", name));
}

} // namespace

void read_extensions(Loader& loader)
{
    Document& document = loader.document;
    document.extensions_used = names(loader, loader.root, "extensionsUsed");
    document.extensions_required = names(loader, loader.root, "extensionsRequired");
    for (const std::string& name : document.extensions_required) check_required(loader, name);
    for (const std::string& name : document.extensions_used) {
        if (name == "EXT_texture_webp" && !can_decode_webp())
            loader.warn(
                "EXT_texture_webp needs the library libwebp, without which this program was built; "
                "WebP textures are not shown");
        if (is_supported(name)) continue;
        const Unsupported* const known = find_unsupported(name);
        loader.warn(
            "extension " + name, fmt::format("the extension '{}' is not supported: {}", name,
                                     known ? known->effect : "what it describes is not shown"));
    }
}

} // namespace firsthit::gltf
