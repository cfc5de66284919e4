// pencil_mesh.h - the scene's triangles in the space of a pencil of rays, and projected to its
// faces.
//
// First make_pencil_mesh moves all vertices into the pencil's space. Then, face by face, either
// find_triangles_in_view projects vertices and keeps the triangles that matter, or
// quantize_all_vertices makes the coordinates that the sample grid (grid/sample_grid.h) works with.
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"
#include "exact/cutouts.h"
#include "exact/shadow_ray.h"
#include "irregular/grid/quantized_points.h"
#include "irregular/mesh/cube_face.h"
#include "irregular/mesh/samples.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <limits>
#include <span>

namespace firsthit {

/// A triangle projected to a face: its box, and the w of its nearest corner. A triangle that
/// reaches behind the plane c = 0 has an infinite nearest_w, and the box of the part in front. 24
/// bytes.
struct ProjectedTriangle {
    std::uint32_t triangle; // index into PencilMesh::index
    float x0, y0, x1, y1;
    float nearest_w;
};

/// Whether a ray to a sample inside the bounds may hit the triangle before it reaches the sample.
/// Never false where one does.
inline bool may_hit(const ProjectedTriangle& box, const SampleBounds& bounds)
{
    return box.x0 <= bounds.x1 && box.x1 >= bounds.x0 && box.y0 <= bounds.y1 &&
           box.y1 >= bounds.y0 && !(box.nearest_w < bounds.farthest_w);
}

/// The least and greatest coordinates of some vertices.
struct VertexBox {
    glm::vec3 low{std::numeric_limits<float>::infinity()};
    glm::vec3 high{-std::numeric_limits<float>::infinity()};

    void add(const VertexBox& other)
    {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
};

/// V vertices and T triangles. The memory is kept from frame to frame.
struct PencilMesh {
    PencilSpace space;
    /// The number of a face to which all vertices project with |x| and |y| below kWideFaceLimit; -1
    /// if there is none. It takes the samples that up to six faces would share otherwise: each face
    /// costs a pass over all triangles.
    int wide_face = -1;
    std::span<const glm::uvec3> index; // (T)
    Cutouts cutouts; // which of them shadow only where they are there; set before the mesh is used
    Buffer<glm::vec3> corner; // (V) in the pencil's space; these floats are taken as exact

    // Of one face, which these functions set.
    CubeFace face;
    Buffer<ProjectedPoint> projected; // (V) x is NaN: the vertex is behind the face or unusable
    Buffer<QuantizedPoint> quantized; // (V) only for a face whose samples are in a SampleGrid
    /// (T) triangles that may be hit; those of range r are the first range_count[r] elements from
    /// index r * kMeshRange on, and the elements after them are garbage.
    Buffer<ProjectedTriangle, Pages::small> in_view;
    Buffer<std::uint32_t> range_count; // (ranges of triangles)
    Buffer<VertexBox> range_box;       // (ranges of vertices)

    /// The corners of a triangle in the pencil's space.
    Corners corners(std::uint32_t triangle) const
    {
        const glm::uvec3& c = index[triangle];
        return {corner[c.x], corner[c.y], corner[c.z]};
    }
};

/// Triangles and vertices are worked on in ranges of this many consecutive ones, a task each.
inline constexpr std::size_t kMeshRange = 8192;

/// Projects `count` vertices to the face. x is NaN for those that are behind it or unusable.
void project_vertices_to_face(
    const CubeFace& face, const glm::vec3* corner, std::size_t count, ProjectedPoint* projected);

/// Moves `count` vertices into the pencil's space with the roundings of to_light, and returns their
/// box. For a parallel pencil the returned box is empty.
VertexBox move_to_pencil_space(
    const PencilSpace& space, const glm::vec3* position, std::size_t count, glm::vec3* corner);

/// The number of the face to which all of the box projects with |x| and |y| below kWideFaceLimit:
/// the face with the smallest largest |x| or |y|. -1 if there is none.
int find_wide_face(const VertexBox& box);

/// Moves all vertices into the pencil's space and finds the wide face. The span `index` must
/// outlive the mesh's use.
void make_pencil_mesh(const PencilSpace& space, std::span<const glm::vec3> position,
    std::span<const glm::uvec3> index, PencilMesh& mesh, Tasks& tasks);

/// Fills in mesh.face and mesh.projected.
void project_all_vertices(const CubeFace& face, PencilMesh& mesh, Tasks& tasks);

/// Fills in mesh.face and mesh.quantized; mesh.projected is left as it is.
void quantize_all_vertices(
    const CubeFace& face, const GridAxes& axes, PencilMesh& mesh, Tasks& tasks);

/// The box of a triangle of which a corner is behind the face (c <= 0) or unusable. Returns false,
/// and leaves the box as it is, if no ray of the face hits the triangle.
bool project_clipped(const CubeFace& face, const Corners& corners, ProjectedTriangle& box);

/// Projects all vertices to the face and fills in mesh.in_view and mesh.range_count with the
/// triangles that rays to samples inside the bounds may hit (may_hit). No triangle that is hit is
/// left out.
void find_triangles_in_view(
    const CubeFace& face, const SampleBounds& bounds, PencilMesh& mesh, Tasks& tasks);

} // namespace firsthit
