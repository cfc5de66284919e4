// meshopt.h - buffer views that EXT_meshopt_compression packed, unpacked by meshoptimizer.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace firsthit::gltf {

inline constexpr const char* kNoMeshopt =
    "EXT_meshopt_compression needs the library meshoptimizer, without which this program was built";

struct MeshoptLayout {
    std::size_t stride = 0; // bytes of an element
    std::size_t count = 0;  // elements
    std::string mode;       // ATTRIBUTES, TRIANGLES, INDICES
    std::string filter;     // NONE or empty, OCTAHEDRAL, QUATERNION, EXPONENTIAL
};

/// Whether the library was there at build time.
bool can_unpack_meshopt();

/// What is wrong with a layout, empty if nothing: an unknown mode, more elements than `packed` bytes
/// can hold.
std::string check_meshopt(const MeshoptLayout& layout, std::size_t packed);

/// Writes count * stride bytes. The layout was checked.
/// returns  false where the data are damaged
bool unpack_meshopt(const MeshoptLayout& layout, std::span<const char> packed, char* unpacked);

} // namespace firsthit::gltf
