// ply_header.h - what a PLY file says about itself.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace firsthit {

enum class PlyFormat { ascii, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    bool is_list = false;
    PlyType count_type = PlyType::uint8; // of a list
    bool used = false; // a position, normal or texture coordinate; a face's vertex indices
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    PlyElement vertex;
    PlyElement face;
    std::size_t size = 0;  // bytes up to the first element
    std::size_t lines = 0; // in those bytes
};

/// Reads a header whose first two elements are vertex and face; later ones are left out.
///
/// throws  FileError: no PLY file, an unknown format, type or keyword, a property that is missing,
///         twice there or of the wrong kind, elements in another order
PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

std::size_t ply_type_size(PlyType type);

/// The value of that type at an address.
double ply_value(const char* bytes, PlyType type, bool big_endian);

} // namespace firsthit
