// lift_points.h - moves points off the triangles that they lie on (exact/shadow_ray.h).
#pragma once

#include "irregular/light_mesh.h"
#include "irregular/see_points.h"

#include <cstdint>

namespace firsthit {

/// The point d of the item, as shadows take it: lifted, exactly. As it is where item is kNoItem.
glm::vec3 lift_point(const LightMesh& mesh, std::uint32_t item, const glm::vec3& d);

/// The same for all points of a chunk, in place.
/// items  of the points: items[id - first_id]
void lift_points(
    const LightMesh& mesh, const std::uint32_t* items, std::uint32_t first_id, LightChunk& chunk);

} // namespace firsthit
