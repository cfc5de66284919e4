// accessor.h - where a glTF document keeps its numbers, and reading them.
#pragma once

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace firsthit::gltf {

struct Document;
struct Primitive;

/// Stands where a document names no node, mesh, accessor, ...
inline constexpr int kNone = -1;

/// The file's own codes.
enum class ComponentType {
    kByte = 5120,
    kUnsignedByte = 5121,
    kShort = 5122,
    kUnsignedShort = 5123,
    kUnsignedInt = 5125,
    kFloat = 5126,
};

enum class ElementType { kScalar, kVec2, kVec3, kVec4, kMat2, kMat3, kMat4 };

/// Bytes of one component, of an element's components.
std::size_t component_size(ComponentType type);
/// Whether it is an integer without a sign.
bool is_unsigned(ComponentType type);
/// How many components an element has: 1 to 16.
int component_count(ElementType type);

/// Buffer::missing of a buffer without a uri that is not a GLB file's own: its bytes are elsewhere.
inline constexpr const char* kNoUri = "its buffer has no uri";

/// A file's bytes. Views of it stay valid as long as any copy of the document lives.
struct Buffer {
    std::shared_ptr<const std::string> storage; // none: the buffer has no bytes
    std::span<const char> bytes;                // at most byte_length
    std::size_t byte_length = 0;                // as the document has it
    std::string missing;                        // why it has none, for messages
};

/// A part of a buffer. What EXT_meshopt_compression packed is unpacked here.
struct BufferView {
    std::string name;
    std::shared_ptr<const std::string> storage; // none: see missing
    std::span<const char> bytes;
    std::size_t byte_length = 0; // as the document has it, also where the bytes are missing
    std::size_t byte_stride = 0; // between elements; 0: they are packed
    std::string missing;         // why its bytes are not there, for messages
};

/// Elements that differ from what the accessor's buffer view (or zeros) says.
struct SparseElements {
    std::size_t count = 0;
    int index_view = kNone;
    std::size_t index_offset = 0; // bytes
    ComponentType index_type = ComponentType::kUnsignedInt;
    int value_view = kNone;
    std::size_t value_offset = 0; // bytes
};

/// All of it lies within its buffer views.
struct Accessor {
    std::string name;
    ComponentType component = ComponentType::kFloat;
    ElementType type = ElementType::kScalar;
    bool normalized = false;
    std::size_t count = 0;       // elements
    int buffer_view = kNone;     // none: zeros
    std::size_t byte_offset = 0; // in the buffer view
    std::optional<SparseElements> sparse;
    std::string unreadable; // why it cannot be read, for messages; empty: it can

    int components() const { return component_count(type); }
};

/// The numbers of an accessor: count * components, element by element, columns of a matrix one after
/// the other. Integers become floats as they are, normalised ones by the specification's formulas.
/// throws  FileError: the accessor has another number of components, or its bytes are not there
///         SceneError: a number is not finite (names accessor and element)
std::vector<float> read_floats(const Document& document, int accessor, int components);

/// The same for integers of 1, 2 or 4 bytes without a sign, such as joints. Not scaled.
/// throws  FileError: the accessor is of another type, or its bytes are not there
std::vector<std::uint32_t> read_uints(const Document& document, int accessor, int components);

/// The matrices of a MAT4 accessor.
std::vector<glm::mat4> read_matrices(const Document& document, int accessor);

/// What a primitive's corners are, in the file's order: its indices, or 0, 1, 2, ... where it has none.
/// vertices  how many there are; every index is below it
/// throws    SceneError: an index out of range (names accessor and element), FileError as above
std::vector<std::uint32_t> read_indices(
    const Document& document, const Primitive& primitive, std::size_t vertices);

} // namespace firsthit::gltf
