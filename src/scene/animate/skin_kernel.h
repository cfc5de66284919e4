// skin_kernel.h - moves vertices by the joints of a skin, and adds morph targets to them.
#pragma once

#include "scene/animate/pose_kernel.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>

namespace firsthit {

/// The skin of a range of vertices.
struct SkinnedVertices {
    const float* joint_matrix;  // (joints, 16) world_from_object, column by column
    int influences;             // of a vertex, 1 or more
    const std::uint16_t* joint; // (V, influences) below the number of joints
    const float* weight;        // (V, influences)
};

/// Writes world-space positions and unit normals: the matrix of a vertex is the sum of its joints'
/// matrices times their weights. A normal is moved by the cofactors of that matrix, which are right for
/// any scale, and is (0, 0, 1) where it has no direction left. The same bits for every instruction set.
/// The outputs may be the inputs.
///
/// returns  whether all positions are finite
/// source   glTF 2.0 specification, 3.7.3.3 "Skinned Mesh Attributes"
bool skin_vertices(const SkinnedVertices& skin, std::size_t count, const ObjectVertices& from,
    const MovedVertices& to);

/// Turns tangents by the same matrices, unit; w changes its sign where the matrix mirrors.
void skin_tangents(const SkinnedVertices& skin, std::size_t count, const glm::vec4* tangent,
    glm::vec4* moved_tangent);

/// sum[k] += weight * term[k], product and sum rounded one after the other.
void add_weighted(float weight, const float* term, std::size_t count, float* sum);

} // namespace firsthit
