// accessor.cpp - reads the elements of accessors in bulk.
#include "readers/gltf/data/accessor.h"

#include "readers/gltf/data/accessor_layout.h"
#include "readers/gltf/document/document.h"
#include "readers/gltf/document/place.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>
#include <type_traits>

namespace firsthit::gltf {
namespace {

std::string place_of(const Document& document, int accessor)
{
    const std::string& name = document.accessors[std::size_t(accessor)].name;
    return fmt::format("{}: accessors[{}]{}", document.name, accessor,
        name.empty() ? "" : shown(fmt::format(" '{}'", name)));
}

/// Normalised integers by section 3.11 of the specification.
template <class Out, class In, bool normalized>
Out converted(In value)
{
    if constexpr (!normalized || std::is_floating_point_v<In>) {
        return static_cast<Out>(value);
    } else {
        constexpr float kMost = static_cast<float>(std::numeric_limits<In>::max());
        const float scaled = static_cast<float>(value) / kMost;
        return static_cast<Out>(std::is_signed_v<In> ? std::max(scaled, -1.0f) : scaled);
    }
}

/// Where elements are taken from, and where they go to.
struct Elements {
    const char* bytes = nullptr; // of the first element
    std::size_t count = 0;
    std::size_t stride = 0;
    ElementLayout layout;
};

template <class Out, class In, bool normalized>
void copy_elements(const Elements& from, Out* out)
{
    const auto components = static_cast<std::size_t>(from.layout.components);
    if (from.layout.packed && from.stride == from.layout.size) {
        const std::size_t numbers = from.count * components;
        if constexpr (std::is_same_v<In, Out>) {
            if (numbers != 0) std::memcpy(out, from.bytes, numbers * sizeof(Out));
            return;
        }
        for (std::size_t k = 0; k < numbers; ++k) {
            In value;
            std::memcpy(&value, from.bytes + k * sizeof(In), sizeof(In));
            out[k] = converted<Out, In, normalized>(value);
        }
        return;
    }
    for (std::size_t element = 0; element < from.count; ++element) {
        const char* const bytes = from.bytes + element * from.stride;
        for (std::size_t k = 0; k < components; ++k) {
            In value;
            std::memcpy(&value, bytes + from.layout.offset[k], sizeof(In));
            out[element * components + k] = converted<Out, In, normalized>(value);
        }
    }
}

template <class Out, class In>
void copy_maybe_normalized(const Elements& from, bool normalized, Out* out)
{
    if (normalized && std::is_same_v<Out, float>)
        copy_elements<Out, In, std::is_same_v<Out, float>>(from, out);
    else
        copy_elements<Out, In, false>(from, out);
}

template <class Out>
void copy_any(const Elements& from, ComponentType type, bool normalized, Out* out)
{
    switch (type) {
    case ComponentType::kByte:
        return copy_maybe_normalized<Out, std::int8_t>(from, normalized, out);
    case ComponentType::kUnsignedByte:
        return copy_maybe_normalized<Out, std::uint8_t>(from, normalized, out);
    case ComponentType::kShort:
        return copy_maybe_normalized<Out, std::int16_t>(from, normalized, out);
    case ComponentType::kUnsignedShort:
        return copy_maybe_normalized<Out, std::uint16_t>(from, normalized, out);
    case ComponentType::kUnsignedInt:
        return copy_maybe_normalized<Out, std::uint32_t>(from, normalized, out);
    case ComponentType::kFloat:
        // Only read_floats asks for these.
        if constexpr (std::is_same_v<Out, float>) copy_elements<float, float, false>(from, out);
        return;
    }
}

/// The bytes of a run that was checked against byte_length when the document was read.
const char* bytes_of(const Document& document, int accessor, int view, std::size_t offset)
{
    const BufferView& from = document.buffer_views[std::size_t(view)];
    if (!from.storage)
        throw FileError(fmt::format(
            "{}: its bytes are missing: {}", place_of(document, accessor), from.missing));
    return from.bytes.data() + offset;
}

template <class Out>
void apply_sparse(const Document& document, int number, Out* out)
{
    const Accessor& accessor = document.accessors[std::size_t(number)];
    const SparseElements& sparse = *accessor.sparse;
    const auto components = static_cast<std::size_t>(accessor.components());

    std::vector<std::uint32_t> index(sparse.count);
    Elements from;
    from.bytes = bytes_of(document, number, sparse.index_view, sparse.index_offset);
    from.count = sparse.count;
    from.layout = element_layout(sparse.index_type, ElementType::kScalar);
    from.stride = from.layout.size;
    copy_any(from, sparse.index_type, false, index.data());

    std::vector<Out> value(sparse.count * components);
    from.bytes = bytes_of(document, number, sparse.value_view, sparse.value_offset);
    from.layout = element_layout(accessor.component, accessor.type);
    from.stride = from.layout.size;
    copy_any(from, accessor.component, accessor.normalized, value.data());

    for (std::size_t k = 0; k < sparse.count; ++k) {
        if (index[k] >= accessor.count)
            throw SceneError(fmt::format("{}: sparse index {} is out of range ({} elements)",
                place_of(document, number), index[k], accessor.count));
        std::copy_n(value.data() + k * components, components, out + index[k] * components);
    }
}

template <class Out>
std::vector<Out> read_numbers(const Document& document, int number)
{
    const Accessor& accessor = document.accessors[std::size_t(number)];
    std::vector<Out> out(accessor.count * static_cast<std::size_t>(accessor.components()));
    if (accessor.buffer_view != kNone && accessor.count != 0) {
        Elements from;
        from.bytes = bytes_of(document, number, accessor.buffer_view, accessor.byte_offset);
        from.count = accessor.count;
        from.layout = element_layout(accessor.component, accessor.type);
        const std::size_t stride =
            document.buffer_views[std::size_t(accessor.buffer_view)].byte_stride;
        from.stride = stride != 0 ? stride : from.layout.size;
        copy_any(from, accessor.component, accessor.normalized, out.data());
    }
    if (accessor.sparse) apply_sparse(document, number, out.data());
    return out;
}

const Accessor& checked(const Document& document, int number, int components)
{
    const Accessor& accessor = document.accessors[std::size_t(number)];
    if (!accessor.unreadable.empty())
        throw FileError(
            fmt::format("{}: cannot be read: {}", place_of(document, number), accessor.unreadable));
    if (accessor.components() != components)
        throw FileError(fmt::format("{}: has {} components, {} were expected",
            place_of(document, number), accessor.components(), components));
    return accessor;
}

} // namespace

std::size_t component_size(ComponentType type)
{
    switch (type) {
    case ComponentType::kByte:
    case ComponentType::kUnsignedByte:
        return 1;
    case ComponentType::kShort:
    case ComponentType::kUnsignedShort:
        return 2;
    case ComponentType::kUnsignedInt:
    case ComponentType::kFloat:
        break;
    }
    return 4;
}

bool is_unsigned(ComponentType type)
{
    return type == ComponentType::kUnsignedByte || type == ComponentType::kUnsignedShort ||
           type == ComponentType::kUnsignedInt;
}

int component_count(ElementType type)
{
    constexpr int kCount[] = {1, 2, 3, 4, 4, 9, 16};
    return kCount[static_cast<int>(type)];
}

ElementLayout element_layout(ComponentType component, ElementType type)
{
    ElementLayout layout;
    layout.components = component_count(type);
    const std::size_t size = component_size(component);
    const auto components = static_cast<std::size_t>(layout.components);
    const bool is_matrix = type >= ElementType::kMat2;
    const std::size_t rows = !is_matrix                   ? components
                             : type == ElementType::kMat2 ? 2
                             : type == ElementType::kMat3 ? 3
                                                          : 4;
    // Columns of matrices start at multiples of four bytes.
    const std::size_t column = is_matrix ? (rows * size + 3) / 4 * 4 : rows * size;
    for (std::size_t k = 0; k < components; ++k)
        layout.offset[k] = k / rows * column + k % rows * size;
    layout.size = components / rows * column;
    layout.packed = column == rows * size;
    return layout;
}

std::vector<float> read_floats(const Document& document, int accessor, int components)
{
    checked(document, accessor, components);
    std::vector<float> values = read_numbers<float>(document, accessor);
    constexpr std::uint32_t kInfinite = 0x7F800000;
    const auto not_finite = [](float value) {
        return (std::bit_cast<std::uint32_t>(value) & kInfinite) == kInfinite;
    };
    std::uint32_t found = 0;
    for (const float value : values) found |= std::uint32_t(not_finite(value));
    if (found != 0) {
        const auto first = std::find_if(values.begin(), values.end(), not_finite);
        throw SceneError(fmt::format("{}: element {} is not finite", place_of(document, accessor),
            (first - values.begin()) / components));
    }
    return values;
}

std::vector<std::uint32_t> read_uints(const Document& document, int accessor, int components)
{
    const ComponentType type = checked(document, accessor, components).component;
    if (!is_unsigned(type))
        throw FileError(
            fmt::format("{}: componentType {} is not accepted; accepted are 5121, 5123, 5125",
                place_of(document, accessor), static_cast<int>(type)));
    return read_numbers<std::uint32_t>(document, accessor);
}

std::vector<glm::mat4> read_matrices(const Document& document, int accessor)
{
    const std::vector<float> values = read_floats(document, accessor, 16);
    std::vector<glm::mat4> matrices(values.size() / 16);
    static_assert(sizeof(glm::mat4) == 16 * sizeof(float));
    if (!values.empty())
        std::memcpy(
            static_cast<void*>(matrices.data()), values.data(), values.size() * sizeof(float));
    return matrices;
}

std::vector<std::uint32_t> read_indices(
    const Document& document, const Primitive& primitive, std::size_t vertices)
{
    if (primitive.indices == kNone) {
        std::vector<std::uint32_t> index(vertices);
        std::iota(index.begin(), index.end(), 0u);
        return index;
    }
    std::vector<std::uint32_t> index = read_uints(document, primitive.indices, 1);
    std::uint32_t most = 0;
    for (const std::uint32_t value : index) most = std::max(most, value);
    if (!index.empty() && most >= vertices) {
        const auto first = std::find_if(
            index.begin(), index.end(), [&](std::uint32_t value) { return value >= vertices; });
        throw SceneError(fmt::format("{}: element {}: index {} is out of range ({} vertices)",
            place_of(document, primitive.indices), first - index.begin(), *first, vertices));
    }
    return index;
}

} // namespace firsthit::gltf
