// pose_kernel.h - moves many vertices by one matrix.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstddef>

namespace firsthit {

/// What moves the vertices of one node: a matrix in double, rounded once.
struct VertexMatrix {
    float point[12]; // world = (rows of 3 by columns of 4) * (p, 1), row by row
    float normal[9]; // the inverse transpose, up to a positive factor, row by row
};

/// Also for matrices without an inverse: a plane that is squashed keeps its normal.
VertexMatrix vertex_matrix(const glm::dmat4& world_from_object);

/// Vertices in object space.
struct ObjectVertices {
    const glm::vec3* position;
    const glm::vec3* normal;
};

/// Where moved vertices go.
struct MovedVertices {
    glm::vec3* position;
    glm::vec3* normal;
};

/// Writes world-space positions and unit normals; (0, 0, 1) where a normal has no direction left.
/// The same bits for every instruction set. The outputs may be the inputs.
///
/// returns  whether all positions are finite
bool move_vertices(const VertexMatrix& matrix, std::size_t count, const ObjectVertices& from,
    const MovedVertices& to);

} // namespace firsthit
