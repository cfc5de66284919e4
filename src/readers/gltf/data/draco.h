// draco.h - triangles that KHR_draco_mesh_compression packed, unpacked by the library Draco.
#pragma once

#include "readers/gltf/data/accessor.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace firsthit::gltf {

inline constexpr const char* kNoDraco =
    "KHR_draco_mesh_compression needs the library Draco, without which this program was built";

/// What an accessor wants of an attribute.
struct DracoRequest {
    std::uint32_t id = 0; // in the compressed data
    ComponentType component = ComponentType::kFloat;
    int components = 0;
};

struct DracoMesh {
    std::size_t points = 0;
    std::vector<std::uint32_t> index;   // three a triangle, each below points
    std::vector<std::string> attribute; // one a request: points elements, packed
};

/// Whether the library was there at build time.
bool can_decode_draco();

/// What is wrong with the sizes that the data promise, empty if nothing: more triangles than so many
/// bytes can hold.
std::string check_draco_sizes(std::span<const char> packed);

/// returns  what is wrong with the data, empty if nothing. Never throws for what they contain
std::string decode_draco(
    std::span<const char> packed, std::span<const DracoRequest> requests, DracoMesh& mesh);

} // namespace firsthit::gltf
