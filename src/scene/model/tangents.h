// tangents.h - tangents of meshes that bring none.
#pragma once

#include <firsthit/mesh.h>

#include <glm/mat3x2.hpp>

#include <vector>

namespace firsthit {

/// Unit tangents of a mesh's vertices: the way in which the texture coordinate u grows, at right angles to the
/// normal; w is 1, or -1 where the texture is seen mirrored (see Mesh). Each triangle counts by its angle at
/// the vertex. A vertex whose triangles say nothing has any tangent at right angles to its normal.
///
/// uv         (V) mesh.uv or mesh.uv1
/// transform  where a texture is sampled (TextureRef)
std::vector<glm::vec4> derived_tangents(
    const Mesh& mesh, const std::vector<glm::vec2>& uv, const glm::mat3x2& transform);

} // namespace firsthit
