// read_meshes.cpp - the meshes of a glTF document.
#include "readers/gltf/document/check_attributes.h"
#include "readers/gltf/document/loader.h"
#include "readers/gltf/data/read_draco.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace firsthit::gltf {
namespace {

Attributes read_attributes(const Loader& loader, const Place& place)
{
    Attributes attributes;
    place.each_index(loader.document.accessors.size(),
        [&](const std::string& name, int accessor) { attributes[name] = accessor; });
    return attributes;
}

Primitive read_primitive(Loader& loader, const Place& place)
{
    Document& document = loader.document;
    Primitive primitive;
    primitive.mode = static_cast<PrimitiveMode>(place.size("mode", 4, 6));
    primitive.indices = place.index("indices", document.accessors.size());
    primitive.material = place.index("material", document.materials.size());
    if (const std::optional<Place> attributes = place.find("attributes"))
        primitive.attributes = read_attributes(loader, *attributes);
    place.each("targets", [&](std::size_t, const Place& target) {
        primitive.targets.push_back(read_attributes(loader, target));
    });
    unpack_draco(loader, place, primitive);
    check_primitive(loader, place, primitive);
    return primitive;
}

} // namespace

void read_meshes(Loader& loader)
{
    loader.root.each("meshes", [&](std::size_t, const Place& place) {
        Mesh mesh;
        mesh.name = place.text("name");
        place.each("primitives", [&](std::size_t, const Place& primitive) {
            mesh.primitives.push_back(read_primitive(loader, primitive));
        });
        if (mesh.primitives.empty())
            loader.warn("empty mesh", fmt::format("{} has no primitives", place.path()));

        std::size_t targets = 0;
        for (const Primitive& primitive : mesh.primitives)
            targets = std::max(targets, primitive.targets.size());
        for (Primitive& primitive : mesh.primitives) {
            if (primitive.targets.size() == targets) continue;
            loader.warn("targets", fmt::format("the primitives of {} have unequal numbers of morph "
                                               "targets; missing ones change nothing",
                                       place.path()));
            loader.take(place, (targets - primitive.targets.size()) * sizeof(Attributes));
            primitive.targets.resize(targets);
        }
        mesh.weights = place.numbers("weights");
        if (!mesh.weights.empty() && mesh.weights.size() != targets) {
            loader.warn("weights", fmt::format("{} has {} weights for {} morph targets",
                                       place.path(), mesh.weights.size(), targets));
            mesh.weights.resize(targets);
        }
        loader.document.meshes.push_back(std::move(mesh));
    });
}

} // namespace firsthit::gltf
