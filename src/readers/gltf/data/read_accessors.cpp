// read_accessors.cpp - the accessors of a glTF document, checked against their buffer views.
#include "readers/gltf/data/accessor_layout.h"
#include "readers/gltf/document/loader.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace firsthit::gltf {
namespace {

constexpr std::size_t kMaxElements = std::size_t(1) << 28;

std::optional<ComponentType> component_type(const Place& place)
{
    const std::size_t code = place.size("componentType");
    for (const ComponentType type :
        {ComponentType::kByte, ComponentType::kUnsignedByte, ComponentType::kShort,
            ComponentType::kUnsignedShort, ComponentType::kUnsignedInt, ComponentType::kFloat})
        if (static_cast<std::size_t>(type) == code) return type;
    return std::nullopt;
}

std::optional<ElementType> element_type(const Place& place)
{
    constexpr std::array<std::pair<std::string_view, ElementType>, 7> kTypes = {
        {{"SCALAR", ElementType::kScalar}, {"VEC2", ElementType::kVec2},
            {"VEC3", ElementType::kVec3}, {"VEC4", ElementType::kVec4},
            {"MAT2", ElementType::kMat2}, {"MAT3", ElementType::kMat3},
            {"MAT4", ElementType::kMat4}}};
    const std::string name = place.text("type");
    for (const auto& [text, type] : kTypes)
        if (text == name) return type;
    return std::nullopt;
}

/// Elements of a buffer view that an accessor reads.
struct Run {
    int view = kNone;
    std::size_t offset = 0;
    std::size_t count = 0;
    std::size_t size = 0;      // of an element
    std::size_t alignment = 1; // of a component
};

void check_run(Loader& loader, const Place& place, const Run& run, bool strided)
{
    const BufferView& view = loader.document.buffer_views[std::size_t(run.view)];
    if (view.byte_stride != 0 && !strided)
        loader.warn("sparse stride",
            fmt::format("{} uses a buffer view with a byteStride, which is ignored", place.path()));
    const std::size_t stride = strided && view.byte_stride != 0 ? view.byte_stride : run.size;
    if (stride < run.size)
        place.fail(
            "", fmt::format(
                    "the byteStride {} of its buffer view is smaller than an element ({} bytes)",
                    stride, run.size));
    const std::size_t needed = bytes_needed(run.count, stride, run.size);
    if (run.offset > view.byte_length || needed > view.byte_length - run.offset)
        place.fail("", fmt::format("needs bytes {} to {} of buffer view {}, which has {}",
                           run.offset, run.offset + needed, run.view, view.byte_length));
    if (run.offset % run.alignment != 0 || (run.count > 1 && stride % run.alignment != 0))
        loader.warn("alignment", fmt::format("{} is not aligned to its components of {} bytes",
                                     place.path(), run.alignment));
}

SparseElements read_sparse(Loader& loader, const Place& place, const Accessor& accessor)
{
    const std::size_t views = loader.document.buffer_views.size();
    SparseElements sparse;
    sparse.count = place.size("count");
    if (sparse.count > accessor.count)
        place.fail("count", fmt::format("{} is more than the accessor's {} elements", sparse.count,
                                accessor.count));
    const std::optional<Place> indices = place.find("indices");
    const std::optional<Place> values = place.find("values");
    if (!indices || !values) place.fail("", "indices or values are missing");
    sparse.index_view = indices->required_index("bufferView", views);
    sparse.index_offset = indices->size("byteOffset", 0);
    const std::optional<ComponentType> index_type = component_type(*indices);
    if (!index_type || !is_unsigned(*index_type))
        indices->fail("componentType", "is unknown or has a sign; accepted are 5121, 5123, 5125");
    sparse.index_type = *index_type;
    sparse.value_view = values->required_index("bufferView", views);
    sparse.value_offset = values->size("byteOffset", 0);
    const std::size_t index_size = component_size(sparse.index_type);
    check_run(loader, *indices,
        {.view = sparse.index_view,
            .offset = sparse.index_offset,
            .count = sparse.count,
            .size = index_size,
            .alignment = index_size},
        false);
    check_run(loader, *values,
        {.view = sparse.value_view,
            .offset = sparse.value_offset,
            .count = sparse.count,
            .size = element_layout(accessor.component, accessor.type).size,
            .alignment = component_size(accessor.component)},
        false);
    return sparse;
}

} // namespace

void read_accessors(Loader& loader)
{
    Document& document = loader.document;
    loader.root.each("accessors", [&](std::size_t, const Place& place) {
        Accessor accessor;
        accessor.name = place.text("name");
        accessor.count = place.size("count");
        const std::optional<ComponentType> component = component_type(place);
        const std::optional<ElementType> type = element_type(place);
        if (!component || !type) {
            // It is valid as long as nothing uses it.
            accessor.unreadable =
                "its componentType or type is unknown; accepted are 5120 to 5123, 5125, 5126 and "
                "SCALAR, VEC2 to VEC4, MAT2 to MAT4";
            loader.warn("unknown type",
                fmt::format("{} cannot be read: {}", place.path(), accessor.unreadable));
            document.accessors.push_back(std::move(accessor));
            return;
        }
        accessor.component = *component;
        accessor.type = *type;
        accessor.normalized = place.boolean("normalized", false);
        if (accessor.normalized && (accessor.component == ComponentType::kFloat ||
                                       accessor.component == ComponentType::kUnsignedInt)) {
            loader.warn(
                "normalized", fmt::format("{}.normalized is ignored: its components are floats or "
                                          "32-bit integers",
                                  place.path()));
            accessor.normalized = false;
        }
        if (accessor.count > kMaxElements)
            place.fail("count",
                fmt::format("{} elements, at most {} are accepted", accessor.count, kMaxElements));
        if (accessor.count == 0)
            loader.warn("empty accessor", fmt::format("{} has no elements", place.path()));
        accessor.buffer_view = place.index("bufferView", document.buffer_views.size());
        accessor.byte_offset = place.size("byteOffset", 0);
        if (accessor.buffer_view == kNone && place.has("byteOffset"))
            loader.warn("offset", fmt::format("{}.byteOffset has no buffer view", place.path()));
        if (accessor.buffer_view != kNone)
            check_run(loader, place,
                {.view = accessor.buffer_view,
                    .offset = accessor.byte_offset,
                    .count = accessor.count,
                    .size = element_layout(accessor.component, accessor.type).size,
                    .alignment = component_size(accessor.component)},
                true);
        if (const std::optional<Place> sparse = place.find("sparse"))
            accessor.sparse = read_sparse(loader, *sparse, accessor);
        // Whatever is read of it becomes numbers of four bytes.
        loader.take(
            place, std::uint64_t(accessor.count) * std::uint64_t(accessor.components()) * 4);
        document.accessors.push_back(std::move(accessor));
    });
}

} // namespace firsthit::gltf
