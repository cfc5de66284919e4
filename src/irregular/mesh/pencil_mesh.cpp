// pencil_mesh.cpp - the scene's triangles in the space of a pencil of rays, and projected to its
// faces.
#include "irregular/mesh/pencil_mesh.h"

#include "visibility/bin/careful_box.h"

#include <algorithm>
#include <limits>

namespace firsthit {
namespace {

/// Writes the triangles of one range that may be hit by rays to samples inside the bounds to the
/// range's part of mesh.in_view.
void cull_range(std::size_t range, const SampleBounds& bounds, PencilMesh& mesh)
{
    const std::size_t first = range * kMeshRange,
                      last = std::min(mesh.index.size(), first + kMeshRange);
    ProjectedTriangle* kept = &mesh.in_view[first];
    constexpr std::size_t kAhead = 16; // triangles: how far ahead corners are prefetched
    for (std::size_t t = first; t < last; ++t) {
        if (t + kAhead < last)
            for (int k = 0; k < 3; ++k)
                __builtin_prefetch(&mesh.projected[mesh.index[t + kAhead][k]]);
        const glm::uvec3& corner = mesh.index[t];
        const ProjectedPoint &a = mesh.projected[corner.x], &b = mesh.projected[corner.y],
                             &c = mesh.projected[corner.z];
        ProjectedTriangle box{std::uint32_t(t), std::min({a.x, b.x, c.x}),
            std::min({a.y, b.y, c.y}), std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}),
            std::max({a.w, b.w, c.w})};
        const float sum = (a.x + b.x) + c.x; // NaN if a corner is behind the face or unusable
        if (sum != sum) [[unlikely]] {
            if (!project_clipped(mesh.face, mesh.corners(box.triangle), box)) continue;
        }
        *kept = box;
        kept += may_hit(box, bounds);
    }
    mesh.range_count[range] = std::uint32_t(kept - &mesh.in_view[first]);
}

} // namespace

int find_wide_face(const VertexBox& box)
{
    float best = kWideFaceLimit;
    int found = -1;
    for (int number = 0; number < kCubeFaces; ++number) {
        const CubeFace face = cube_face(false, number);
        const glm::vec3 low = face.to_face_axes(box.low), high = face.to_face_axes(box.high);
        const auto farthest = [&](int axis) {
            return std::max(std::abs(low[axis]), std::abs(high[axis]));
        };
        const float nearest = std::min(low.z, high.z);
        if (!(nearest > 0)) continue;
        const float widest = std::max(farthest(0), farthest(1)) / nearest;
        if (widest < best) best = widest, found = number;
    }
    return found;
}

bool project_clipped(const CubeFace& face, const Corners& corners, ProjectedTriangle& box)
{
    if (face.directional || !usable(corners)) return false;
    const Corners turned{face.to_face_axes(corners[0]), face.to_face_axes(corners[1]),
        face.to_face_axes(corners[2])};
    if (!(turned[0].z > 0) && !(turned[1].z > 0) && !(turned[2].z > 0)) return false;
    const Interval x = project_front(turned, 0), y = project_front(turned, 1);
    // The margin is larger than the roundings of x and y to double and then to float.
    constexpr float kMargin = 0x1p-20f * kWideFaceLimit;
    box.x0 = float(x.low) - kMargin, box.x1 = float(x.high) + kMargin;
    box.y0 = float(y.low) - kMargin, box.y1 = float(y.high) + kMargin;
    box.nearest_w = std::numeric_limits<float>::infinity();
    return true;
}

void make_pencil_mesh(const PencilSpace& space, std::span<const glm::vec3> position,
    std::span<const glm::uvec3> index, PencilMesh& mesh, Tasks& tasks)
{
    mesh.space = space;
    mesh.index = index;
    mesh.corner.resize(position.size());
    mesh.projected.resize(position.size());
    mesh.in_view.resize(index.size() + 1);
    mesh.range_count.resize((index.size() + kMeshRange - 1) / kMeshRange);
    mesh.range_box.resize((position.size() + kMeshRange - 1) / kMeshRange);
    tasks.for_ranges(position.size(), kMeshRange, [&](std::size_t first, std::size_t last) {
        mesh.range_box[first / kMeshRange] =
            move_to_pencil_space(space, &position[first], last - first, &mesh.corner[first]);
    });
    VertexBox all;
    for (const VertexBox& box : mesh.range_box.span()) all.add(box);
    mesh.wide_face = space.directional ? -1 : find_wide_face(all);
}

void project_all_vertices(const CubeFace& face, PencilMesh& mesh, Tasks& tasks)
{
    mesh.face = face;
    tasks.for_ranges(mesh.corner.size(), kMeshRange, [&](std::size_t first, std::size_t last) {
        project_vertices_to_face(face, &mesh.corner[first], last - first, &mesh.projected[first]);
    });
}

void quantize_all_vertices(
    const CubeFace& face, const GridAxes& axes, PencilMesh& mesh, Tasks& tasks)
{
    mesh.face = face;
    mesh.quantized.resize(mesh.corner.size());
    tasks.for_ranges(mesh.corner.size(), kMeshRange, [&](std::size_t first, std::size_t last) {
        quantize_vertices(axes, face, &mesh.corner[first], last - first, &mesh.quantized[first]);
    });
}

void find_triangles_in_view(
    const CubeFace& face, const SampleBounds& bounds, PencilMesh& mesh, Tasks& tasks)
{
    project_all_vertices(face, mesh, tasks);
    tasks.for_each(mesh.range_count.size(),
        [&](std::size_t range, std::size_t) { cull_range(range, bounds, mesh); });
}

} // namespace firsthit
