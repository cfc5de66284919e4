// mask_objects.cpp - what gets a mask: instances, nodes or materials, with names and categories.
#include "masks/mask_objects.h"

#include "common/usage.h"

#include <fmt/format.h>

namespace firsthit::cli {
namespace {

std::string mesh_name(const Scene& scene, const Instance& instance)
{
    if (instance.shape < 0) return instance.name;
    const std::string& name = scene.shapes[std::size_t(instance.shape)].name;
    return name.empty() ? instance.name : name;
}

std::string name_of(const Scene& scene, Aov kind, std::size_t object)
{
    return kind == Aov::instance ? scene.instances[object].name
           : kind == Aov::node   ? scene.nodes[object].name
                                 : scene.materials[object].name;
}

std::size_t count_of(const Scene& scene, Aov kind)
{
    return kind == Aov::instance ? scene.instances.size()
           : kind == Aov::node   ? scene.nodes.size()
                                 : scene.materials.size();
}

} // namespace

Aov parse_mask_kind(const std::string& text)
{
    if (text == "instance") return Aov::instance;
    if (text == "node") return Aov::node;
    if (text == "material") return Aov::material;
    throw UsageError(
        fmt::format("'{}' is no kind of object: accepted are instance, node and material", text));
}

MaskObjects mask_objects(const Scene& scene, Aov kind)
{
    MaskObjects objects;
    const std::size_t count = count_of(scene, kind);
    objects.instances.resize(count);
    for (std::uint32_t k = 0; k < scene.instances.size(); ++k) {
        const Instance& instance = scene.instances[k];
        const std::uint32_t object = kind == Aov::instance ? k
                                     : kind == Aov::node   ? instance.node
                                                           : instance.material;
        objects.instances[object].push_back(k);
    }
    for (std::size_t k = 0; k < count; ++k) {
        objects.name.push_back(name_of(scene, kind, k));
        std::string category = kind == Aov::material || objects.instances[k].empty()
                                   ? objects.name[k]
                                   : mesh_name(scene, scene.instances[objects.instances[k][0]]);
        objects.category.push_back(category.empty() ? "object" : std::move(category));
    }
    return objects;
}

} // namespace firsthit::cli
