// pencil_mesh.h - the scene's triangles as a light sees them.
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"
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

/// A triangle that may shadow a sample: the box in which the face sees it, and its nearest corner's
/// w (infinite where it reaches behind the light). 24 bytes.
struct ProjectedTriangle {
    std::uint32_t triangle;
    float x0, y0, x1, y1;
    float nearest_w;
};

/// Whether the triangle may shadow a sample inside the bounds.
inline bool may_shadow(const ProjectedTriangle& box, const SampleBounds& bounds)
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

/// Kept from frame to frame.
struct PencilMesh {
    PencilSpace space;
    /// The face of a point light that sees all that lies in front of it within kWidestFace, where
    /// that is all vertices: six would each go through all triangles. -1: there is none.
    int wide_face = -1;
    std::span<const glm::uvec3> index;
    Buffer<glm::vec3> corner; // (V) in the light's space, exact from here on
    CubeFace face;
    Buffer<ProjectedPoint> seen;  // (V) by the face; x is no number: behind it, or unusable
    Buffer<QuantizedPoint> place; // (V) on the grid of samples, where one is used
    // (T) room; each range of triangles fills the start of its part
    Buffer<ProjectedTriangle, Pages::small> in_view;
    Buffer<std::uint32_t> range_count; // (ranges) triangles in view of each range
    Buffer<VertexBox> range_box;       // (ranges) of vertices

    Corners corners(std::uint32_t triangle) const
    {
        const glm::uvec3& c = index[triangle];
        return {corner[c.x], corner[c.y], corner[c.z]};
    }
};

/// Triangles or vertices of one range.
inline constexpr std::size_t kLightRange = 8192;

/// Some vertices as a face sees them: x is no number for those that are behind it or unusable.
void project_vertices_to_face(
    const CubeFace& face, const glm::vec3* corner, std::size_t count, ProjectedPoint* seen);

/// Moves some vertices into the light's space, as to_light, and says where they lie there; parallel
/// light is not told that.
VertexBox move_vertices(
    const PencilSpace& space, const glm::vec3* position, std::size_t count, glm::vec3* corner);

/// The face of a point light that sees all of the box within kWidestFace, that where it is nearest to
/// the middle; -1 where there is none.
int find_wide_face(const VertexBox& box);

/// Moves all vertices into the light's space, and looks for a wide face.
void see_from_light(const PencilSpace& space, std::span<const glm::vec3> position,
    std::span<const glm::uvec3> index, PencilMesh& mesh, Tasks& tasks);

/// All vertices of the mesh as the face sees them.
void project_all_vertices_to_face(const CubeFace& face, PencilMesh& mesh, Tasks& tasks);

/// Only their places on a grid of the face's samples.
void place_all_vertices(const CubeFace& face, const GridAxes& axes, PencilMesh& mesh, Tasks& tasks);

/// The box of a triangle with a corner behind the face, or with one that makes it invisible: then
/// false.
bool project_carefully(const CubeFace& face, const Corners& corners, ProjectedTriangle& box);

/// Finds the triangles that may shadow samples inside the bounds, which this face sees. No triangle
/// is left out that does.
void project_through_face(
    const CubeFace& face, const SampleBounds& bounds, PencilMesh& mesh, Tasks& tasks);

} // namespace firsthit
