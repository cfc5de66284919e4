// check_attributes.cpp - whether the accessors of a primitive are of the types that glTF allows.
#include "readers/gltf/document/check_attributes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

namespace firsthit::gltf {
namespace {

constexpr std::array<std::string_view, 7> kTypeNames = {
    "SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};

/// What may stand in an attribute.
struct Semantic {
    std::string_view name; // before _0, _1, ...
    bool numbered = false;
    std::vector<ElementType> types;
    std::vector<ElementType> target_types; // in morph targets; empty: not allowed there
    bool core_normalized = false;          // normalised integers without KHR_mesh_quantization
};

const std::array<Semantic, 7>& semantics()
{
    using enum ElementType;
    static const std::array<Semantic, 7> kSemantics = {{
        {"POSITION", false, {kVec3}, {kVec3}, false},
        {"NORMAL", false, {kVec3}, {kVec3}, false},
        {"TANGENT", false, {kVec4}, {kVec3}, false},
        {"TEXCOORD", true, {kVec2}, {kVec2}, true},
        {"COLOR", true, {kVec3, kVec4}, {kVec3, kVec4}, true},
        {"JOINTS", true, {kVec4}, {}, false},
        {"WEIGHTS", true, {kVec4}, {}, true},
    }};
    return kSemantics;
}

/// The semantic of a name such as TEXCOORD_0; nothing where it has none.
const Semantic* find_semantic(std::string_view name)
{
    for (const Semantic& semantic : semantics()) {
        if (!semantic.numbered && name == semantic.name) return &semantic;
        if (!semantic.numbered || !name.starts_with(semantic.name)) continue;
        const std::string_view rest = name.substr(semantic.name.size());
        const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
        if (rest.size() > 1 && rest[0] == '_' &&
            std::all_of(rest.begin() + 1, rest.end(), is_digit))
            return &semantic;
    }
    return nullptr;
}

std::string list_types(const ElementType* types, std::size_t count)
{
    std::string list;
    for (std::size_t k = 0; k < count; ++k)
        list.append(k == 0 ? "" : " or ").append(kTypeNames[std::size_t(types[k])]);
    return list;
}

void check_types(const Loader& loader, const Place& place, std::string_view key, int number,
    const ElementType* types, std::size_t count)
{
    const Accessor& accessor = loader.document.accessors[std::size_t(number)];
    if (!accessor.unreadable.empty())
        place.fail(key, fmt::format("accessor {} cannot be read: {}", number, accessor.unreadable));
    if (std::find(types, types + count, accessor.type) != types + count) return;
    place.fail(key, fmt::format("accessor {} is of type {}; accepted is {}", number,
                        kTypeNames[std::size_t(accessor.type)], list_types(types, count)));
}

/// Are the components of a type that the specification or KHR_mesh_quantization allows?
bool has_usual_components(const Semantic& semantic, const Accessor& accessor, bool quantized)
{
    const ComponentType type = accessor.component;
    if (semantic.name == "JOINTS")
        return type != ComponentType::kUnsignedInt && !accessor.normalized;
    if (type == ComponentType::kFloat) return true;
    if (type == ComponentType::kUnsignedInt) return false;
    if (semantic.core_normalized && is_unsigned(type) && accessor.normalized) return true;
    if (!quantized || semantic.name == "COLOR" || semantic.name == "WEIGHTS") return false;
    if (semantic.name == "NORMAL" || semantic.name == "TANGENT")
        return !is_unsigned(type) && accessor.normalized;
    return true;
}

class PrimitiveCheck {
  public:
    PrimitiveCheck(Loader& loader, const Place& place) : loader_(loader), place_(place)
    {
        const auto& used = loader.document.extensions_used;
        quantized_ = std::find(used.begin(), used.end(), "KHR_mesh_quantization") != used.end();
    }

    void run(const Primitive& primitive)
    {
        check_attributes("attributes", primitive.attributes, false);
        for (std::size_t k = 0; k < primitive.targets.size(); ++k) {
            check_attributes(fmt::format("targets[{}]", k), primitive.targets[k], true);
            for (const auto& [name, accessor] : primitive.targets[k])
                if (!primitive.attributes.contains(name))
                    warn("target base",
                        fmt::format(
                            "morph targets change {}, which the primitive does not have", name));
        }
        if (!primitive.attributes.contains("POSITION"))
            warn("position", "there is no POSITION; the primitive is not shown");
        check_indices(primitive);
        check_textures(primitive);
    }

  private:
    void warn(std::string_view topic, const std::string& message)
    {
        loader_.warn(topic, fmt::format("{}: {}", place_.path(), message));
    }

    void check_attributes(const std::string& key, const Attributes& attributes, bool target)
    {
        for (const auto& [name, number] : attributes) {
            const Accessor& accessor = loader_.document.accessors[std::size_t(number)];
            const std::string at = key + "." + name;
            if (!counted_) count_ = accessor.count;
            counted_ = true;
            if (accessor.count != count_)
                place_.fail(
                    at, fmt::format("accessor {} has {} elements, others of the primitive have {}",
                            number, accessor.count, count_));
            const Semantic* const semantic = find_semantic(name);
            if (!semantic) {
                if (!name.starts_with('_'))
                    warn("semantic " + name,
                        fmt::format("the attribute '{}' is unknown and not used", name));
                continue;
            }
            const std::vector<ElementType>& types =
                target ? semantic->target_types : semantic->types;
            if (types.empty()) {
                warn("target",
                    fmt::format("{} is not accepted in a morph target and not used", name));
                continue;
            }
            check_types(loader_, place_, at, number, types.data(), types.size());
            if (semantic->name == "JOINTS" && !is_unsigned(accessor.component))
                place_.fail(
                    at, fmt::format("componentType {} is not accepted; accepted are 5121, 5123",
                            static_cast<int>(accessor.component)));
            if (!has_usual_components(*semantic, accessor, quantized_))
                warn("components", fmt::format("{} has components of an unusual type ({}{})", name,
                                       static_cast<int>(accessor.component),
                                       accessor.normalized ? ", normalized" : ""));
        }
    }

    void check_indices(const Primitive& primitive)
    {
        std::size_t corners = count_;
        if (primitive.indices != kNone) {
            check_type(loader_, place_, "indices", primitive.indices, {ElementType::kScalar});
            const Accessor& accessor = loader_.document.accessors[std::size_t(primitive.indices)];
            if (!is_unsigned(accessor.component))
                place_.fail("indices",
                    fmt::format("accessor {} has componentType {}; accepted are 5121, 5123, 5125",
                        primitive.indices, static_cast<int>(accessor.component)));
            if (accessor.normalized)
                warn("normalized indices", "its indices are marked as normalized");
            corners = accessor.count;
        }
        if (primitive.mode == PrimitiveMode::kTriangles && corners % 3 != 0)
            warn("left over", fmt::format("{} corners are no whole triangles", corners));
    }

    /// Texture coordinates that the material asks for.
    void check_textures(const Primitive& primitive)
    {
        if (primitive.material == kNone) return;
        const Material& m = loader_.document.materials[std::size_t(primitive.material)];
        for (const TextureInfo* info : {&m.base_color_texture, &m.metallic_roughness_texture,
                 &m.normal_texture, &m.occlusion_texture, &m.emissive_texture}) {
            if (!*info ||
                primitive.attributes.contains(fmt::format("TEXCOORD_{}", info->tex_coord)))
                continue;
            warn("uv",
                fmt::format("its material needs TEXCOORD_{}, which the primitive does not have",
                    info->tex_coord));
        }
    }

    Loader& loader_;
    const Place& place_;
    bool quantized_ = false;
    bool counted_ = false;
    std::size_t count_ = 0;
};

} // namespace

void check_primitive(Loader& loader, const Place& place, const Primitive& primitive)
{
    PrimitiveCheck(loader, place).run(primitive);
}

void check_type(const Loader& loader, const Place& place, std::string_view key, int accessor,
    std::initializer_list<ElementType> types)
{
    check_types(loader, place, key, accessor, types.begin(), types.size());
}

} // namespace firsthit::gltf
