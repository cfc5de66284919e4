// lattice_meshes.h - triangles and rays with small whole coordinates, so that rays pass through edges and vertices,
// lie in planes and along edges, and start on what they might hit.
#pragma once

#include "random_numbers.h"

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace firsthit::test {

struct LatticeMesh {
    std::string name;
    std::vector<glm::ivec3> corner;
    std::vector<glm::uvec3> triangle;
};

/// Meshes with coordinates from -8 to 8.
std::vector<LatticeMesh> lattice_meshes();

struct LatticeRay {
    glm::ivec3 origin, direction; // -16 to 16
};

/// Rays of all kinds, also such without a direction.
std::vector<LatticeRay> lattice_rays(
    const LatticeMesh& mesh, std::size_t count, std::mt19937& random);

} // namespace firsthit::test
