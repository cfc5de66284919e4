// assimp_mesh.h - reads the triangles of a checked mesh file with Assimp.
#pragma once

#include "readers/mesh/checked_mesh.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace firsthit {

/// Bytes: Assimp counts them with 32 bits.
inline constexpr std::size_t kMaxMeshFile = 0xFFFFFFFF;

/// Triangles in file order, vertices as the file has them: not welded.
struct RawMesh {
    std::vector<glm::vec3> position;
    std::vector<glm::vec3>
        normal;                // zero where the file gives none; empty where it gives none at all
    std::vector<glm::vec2> uv; // v = 0 at the bottom, as in the file; may be empty
    std::vector<glm::uvec3> index;
};

/// A face of n corners becomes the fan of n - 2 triangles around its first corner. Faces of fewer
/// corners are left out. Frees the bytes of `checked`.
///
/// extension  ".ply", ".stl" or ".obj"
/// throws     FileError where Assimp fails, or reads something else than what was checked
RawMesh read_with_assimp(
    CheckedMesh& checked, const std::string& extension, const std::string& name);

} // namespace firsthit
