// lift_points.h - lifts points off the triangles that they lie on (exact/shadow_ray.h).
#pragma once

#include "irregular/mesh/pencil_mesh.h"
#include "irregular/mesh/project_points_to_face.h"

#include <cstdint>

namespace firsthit {

/// Lifts the point d, which lies on triangle `item`, towards the light, as shadow tests expect.
/// Returns d unchanged if item is kNoItem. d and the result are in the light's space.
glm::vec3 lift_point(const PencilMesh& mesh, std::uint32_t item, const glm::vec3& d);

/// Lifts all points of a chunk, in place.
/// items  the triangle of the point with id k is items[k - first_id]
void lift_points(
    const PencilMesh& mesh, const std::uint32_t* items, std::uint32_t first_id, PointChunk& chunk);

} // namespace firsthit
