// lift_points.h - moves points off the triangles that they lie on (exact/shadow_ray.h).
#pragma once

#include "irregular/mesh/pencil_mesh.h"
#include "irregular/mesh/project_points_to_face.h"

#include <cstdint>

namespace firsthit {

/// The point d of the item, as shadows take it: lifted, exactly. As it is where item is kNoItem.
glm::vec3 lift_point(const PencilMesh& mesh, std::uint32_t item, const glm::vec3& d);

/// The same for all points of a chunk, in place.
/// items  of the points: items[id - first_id]
void lift_points(
    const PencilMesh& mesh, const std::uint32_t* items, std::uint32_t first_id, PointChunk& chunk);

} // namespace firsthit
