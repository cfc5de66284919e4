// ply_header.h - what a PLY file says about itself.
#pragma once

#include "readers/problems.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit {

enum class PlyFormat { ascii, little_endian, big_endian };
enum class PlyType {
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    float32,
    float64,
    int64, // not of the format, but some writers have them
    uint64
};

/// What the value of a property is used for; of a list all its values.
enum class PlyRole { none, x, y, z, nx, ny, nz, u, v, red, green, blue, alpha, corners, texcoord };

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    bool is_list = false;
    PlyType count_type = PlyType::uint8; // of a list
    PlyRole role = PlyRole::none;
};

struct PlyElement {
    enum class Kind { other, vertex, faces, strips };

    std::string name;
    Kind kind = Kind::other;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;

    bool has(PlyRole role) const;
    bool has_list() const;
    /// The type of the property with that role, which must be there.
    PlyType type_of(PlyRole role) const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;  // in the file's order
    std::vector<std::string> textures; // of comments "TextureFile NAME"
    std::size_t size = 0;              // bytes up to the first element
    std::size_t lines = 0;             // in those bytes

    /// The elements `vertex`, and `face` or `tristrips`, or null.
    const PlyElement* vertex() const;
    const PlyElement* faces() const;
};

/// Reads a header. Unknown words in it, and what stands behind the words of a line, are skipped with a
/// problem; of elements and properties of the same name the first is used.
///
/// throws  FileError: no PLY file, an unknown format or type, no end, no positions, faces without a list
///         of corners
PlyHeader read_ply_header(std::string_view bytes, const std::string& name, Problems& problems);

/// Bytes of a value.
std::size_t ply_type_size(PlyType type);

/// Whether its values are whole numbers.
bool is_whole(PlyType type);

} // namespace firsthit
