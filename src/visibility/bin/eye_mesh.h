// eye_mesh.h - triangles in the eye space of a pencil.
#pragma once

#include "base/buffer.h"
#include "exact/cutouts.h"
#include "exact/hit.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <span>

namespace firsthit {

/// Where a vertex projects to among the samples, along x and y. A coordinate is 2 k + 1 if the
/// vertex lies on sample k, or within the bound of rounding of it, and 2 k if it lies between the
/// samples k - 1 and k; it is clamped to [0, 2 width] or [0, 2 height]. The samples that a triangle
/// may hit follow from the least and the greatest coordinates of its corners. The four bytes are
/// the bits of the fourth coordinate of EyeMesh::corner.
struct VertexSamples {
    std::int16_t x, y;

    /// This value of x means that the vertex has no usable projection, mostly because it is not in
    /// front of the eye. The box of its triangles is found by careful_box.
    static constexpr std::int16_t kBehind = -32768;

    /// The first sample at or after the least coordinate of a triangle's corners.
    static constexpr int first(int least) { return least >> 1; }
    /// The last sample at or before the greatest coordinate; below first() where there is none.
    static constexpr int last(int greatest) { return ((greatest + 1) >> 1) - 1; }
};
static_assert(sizeof(VertexSamples) == sizeof(float));

/// The coordinates in which corners are stored.
enum class CornerSpace {
    eye,  // (x, y, z) in eye space
    flat, // (x/z, y/z, 1/z) for shadow maps; (x, y, z) if VertexSamples::x is kBehind
};

/// The triangles of a world in the eye space of a pencil (exact/pencil.h).
struct EyeMesh {
    std::span<const glm::uvec3> index; // (T) the vertices of each triangle, see Scene::index
    Cutouts cutouts;                   // which of them are not everywhere where a ray hits them
    CornerSpace corner_space = CornerSpace::eye;
    Buffer<glm::vec4> corner; // (V) vertices in corner_space, and the bits of their VertexSamples;
                              // project_vertices adds some for padding
};

/// Makes the scene's triangles the mesh's. The scene has to outlive the mesh's use.
///
/// blend_cutoff  see Cutouts::find
inline void take_triangles(const Scene& scene, EyeMesh& mesh, float blend_cutoff = kSeenOpacity)
{
    mesh.index = scene.index;
    mesh.cutouts.find(scene, blend_cutoff);
}

/// The corners of a triangle of a mesh whose corner_space is CornerSpace::eye.
inline Corners corners_of(const EyeMesh& mesh, std::uint32_t triangle)
{
    const glm::uvec3& vertex = mesh.index[triangle];
    return {glm::vec3(mesh.corner[vertex.x]), glm::vec3(mesh.corner[vertex.y]),
        glm::vec3(mesh.corner[vertex.z])};
}

} // namespace firsthit
