// read_draco.cpp - puts unpacked accessors in the place of a primitive's compressed ones.
#include "readers/gltf/data/read_draco.h"

#include "readers/gltf/data/draco.h"

#include <fmt/format.h>

#include <memory>
#include <utility>
#include <vector>

namespace firsthit::gltf {
namespace {

/// The number of an accessor like `number` with these elements: itself, where nothing else says what
/// its elements are.
int fill(Loader& loader, int number, std::size_t count, ComponentType component, std::string bytes)
{
    Document& document = loader.document;
    Accessor accessor = document.accessors[std::size_t(number)];
    const bool is_free =
        accessor.buffer_view == kNone && !accessor.sparse && accessor.count == count;
    if (accessor.count != count)
        loader.warn(
            "draco count", fmt::format("accessors[{}].count is {}, the compressed data have {}",
                               number, accessor.count, count));
    BufferView view;
    view.storage = std::make_shared<const std::string>(std::move(bytes));
    view.bytes = *view.storage;
    view.byte_length = view.bytes.size();
    accessor.buffer_view = static_cast<int>(document.buffer_views.size());
    document.buffer_views.push_back(std::move(view));
    accessor.byte_offset = 0;
    accessor.sparse.reset();
    accessor.count = count;
    accessor.component = component;
    if (is_free) {
        document.accessors[std::size_t(number)] = std::move(accessor);
        return number;
    }
    document.accessors.push_back(std::move(accessor));
    return static_cast<int>(document.accessors.size() - 1);
}

/// Whether each accessor says itself what its elements are.
bool has_fallback(const Document& document, const Primitive& primitive)
{
    const auto present = [&](int accessor) {
        return accessor == kNone || document.accessors[std::size_t(accessor)].buffer_view != kNone;
    };
    for (const auto& [name, accessor] : primitive.attributes)
        if (!present(accessor)) return false;
    return present(primitive.indices);
}

} // namespace

void unpack_draco(Loader& loader, const Place& place, Primitive& primitive)
{
    Document& document = loader.document;
    const std::optional<Place> packed = place.extension("KHR_draco_mesh_compression");
    if (!packed) return;
    const auto view_number =
        std::size_t(packed->required_index("bufferView", document.buffer_views.size()));
    const std::optional<Place> attributes = packed->find("attributes");
    if (!attributes) packed->fail("attributes", "is missing");
    if (primitive.mode != PrimitiveMode::kTriangles &&
        primitive.mode != PrimitiveMode::kTriangleStrip)
        place.fail(
            "mode", fmt::format("{} is not accepted with KHR_draco_mesh_compression; accepted are "
                                "4 and 5",
                        static_cast<int>(primitive.mode)));

    std::vector<std::string> names;
    std::vector<DracoRequest> requests;
    attributes->each_index(std::size_t(1) << 31, [&](const std::string& name, int id) {
        const auto found = primitive.attributes.find(name);
        if (found == primitive.attributes.end()) {
            loader.warn("draco attribute",
                fmt::format("{}.{} is no attribute of the primitive", attributes->path(), name));
            return;
        }
        const Accessor& accessor = document.accessors[std::size_t(found->second)];
        if (accessor.type >= ElementType::kMat2)
            attributes->fail(name, "its accessor holds matrices");
        names.push_back(name);
        requests.push_back({.id = static_cast<std::uint32_t>(id),
            .component = accessor.component,
            .components = accessor.components()});
    });

    const BufferView view = document.buffer_views[view_number];
    DracoMesh mesh;
    const std::string wrong = view.storage ? decode_draco(view.bytes, requests, mesh)
                                           : "its bytes are missing: " + view.missing;
    if (!wrong.empty()) {
        if (!has_fallback(document, primitive)) packed->fail("", wrong);
        loader.warn(
            "draco", fmt::format("{}: {}; the uncompressed data are shown", packed->path(), wrong));
        return;
    }
    std::uint64_t bytes = mesh.index.size() * sizeof(std::uint32_t);
    for (const std::string& attribute : mesh.attribute) bytes += attribute.size();
    loader.take(*packed, bytes);

    for (std::size_t k = 0; k < names.size(); ++k) {
        int& accessor = primitive.attributes[names[k]];
        accessor = fill(
            loader, accessor, mesh.points, requests[k].component, std::move(mesh.attribute[k]));
    }
    primitive.mode = PrimitiveMode::kTriangles; // Draco knows no strips
    std::string index(reinterpret_cast<const char*>(mesh.index.data()),
        mesh.index.size() * sizeof(std::uint32_t));
    if (primitive.indices == kNone) {
        Accessor& accessor = document.accessors.emplace_back();
        accessor.count = mesh.index.size();
        primitive.indices = static_cast<int>(document.accessors.size() - 1);
    }
    primitive.indices = fill(loader, primitive.indices, mesh.index.size(),
        ComponentType::kUnsignedInt, std::move(index));
}

} // namespace firsthit::gltf
