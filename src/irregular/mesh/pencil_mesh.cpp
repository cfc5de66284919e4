// pencil_mesh.cpp - the scene's triangles as a light sees them.
#include "irregular/mesh/pencil_mesh.h"

#include "visibility/bin/careful_box.h"

#include <algorithm>
#include <limits>

namespace firsthit {
namespace {

/// Keeps the triangles of one range that overlap the samples' bounds.
void see_range(std::size_t range, const SampleBounds& bounds, PencilMesh& mesh)
{
    const std::size_t first = range * kLightRange,
                      last = std::min(mesh.index.size(), first + kLightRange);
    ProjectedTriangle* kept = &mesh.in_view[first];
    constexpr std::size_t kAhead = 16; // triangles whose corners are asked for
    for (std::size_t t = first; t < last; ++t) {
        if (t + kAhead < last)
            for (int k = 0; k < 3; ++k) __builtin_prefetch(&mesh.seen[mesh.index[t + kAhead][k]]);
        const glm::uvec3& corner = mesh.index[t];
        const ProjectedPoint &a = mesh.seen[corner.x], &b = mesh.seen[corner.y],
                             &c = mesh.seen[corner.z];
        ProjectedTriangle box{std::uint32_t(t), std::min({a.x, b.x, c.x}),
            std::min({a.y, b.y, c.y}), std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}),
            std::max({a.w, b.w, c.w})};
        const float sum = (a.x + b.x) + c.x;
        if (sum != sum) [[unlikely]] {
            if (!project_carefully(mesh.face, mesh.corners(box.triangle), box)) continue;
        }
        *kept = box;
        kept += may_shadow(box, bounds);
    }
    mesh.range_count[range] = std::uint32_t(kept - &mesh.in_view[first]);
}

} // namespace

int find_wide_face(const VertexBox& box)
{
    float best = kWidestFace;
    int found = -1;
    for (int number = 0; number < kLightFaces; ++number) {
        const CubeFace face = cube_face(false, number);
        const glm::vec3 low = face.seen_from(box.low), high = face.seen_from(box.high);
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

bool project_carefully(const CubeFace& face, const Corners& corners, ProjectedTriangle& box)
{
    if (face.directional || !usable(corners)) return false;
    const Corners seen{
        face.seen_from(corners[0]), face.seen_from(corners[1]), face.seen_from(corners[2])};
    if (!(seen[0].z > 0) && !(seen[1].z > 0) && !(seen[2].z > 0)) return false;
    const Interval x = project_front(seen, 0), y = project_front(seen, 1);
    // Rounded to double and to float.
    constexpr float kMargin = 0x1p-20f * kWidestFace;
    box.x0 = float(x.low) - kMargin, box.x1 = float(x.high) + kMargin;
    box.y0 = float(y.low) - kMargin, box.y1 = float(y.high) + kMargin;
    box.nearest_w = std::numeric_limits<float>::infinity();
    return true;
}

void see_from_light(const PencilSpace& space, std::span<const glm::vec3> position,
    std::span<const glm::uvec3> index, PencilMesh& mesh, Tasks& tasks)
{
    mesh.space = space;
    mesh.index = index;
    mesh.corner.resize(position.size());
    mesh.seen.resize(position.size());
    mesh.in_view.resize(index.size() + 1);
    mesh.range_count.resize((index.size() + kLightRange - 1) / kLightRange);
    mesh.range_box.resize((position.size() + kLightRange - 1) / kLightRange);
    tasks.for_ranges(position.size(), kLightRange, [&](std::size_t first, std::size_t last) {
        mesh.range_box[first / kLightRange] =
            move_vertices(space, &position[first], last - first, &mesh.corner[first]);
    });
    VertexBox all;
    for (const VertexBox& box : mesh.range_box.span()) all.add(box);
    mesh.wide_face = space.directional ? -1 : find_wide_face(all);
}

void project_all_vertices_to_face(const CubeFace& face, PencilMesh& mesh, Tasks& tasks)
{
    mesh.face = face;
    tasks.for_ranges(mesh.corner.size(), kLightRange, [&](std::size_t first, std::size_t last) {
        project_vertices_to_face(face, &mesh.corner[first], last - first, &mesh.seen[first]);
    });
}

void place_all_vertices(const CubeFace& face, const GridAxes& axes, PencilMesh& mesh, Tasks& tasks)
{
    mesh.face = face;
    mesh.place.resize(mesh.corner.size());
    tasks.for_ranges(mesh.corner.size(), kLightRange, [&](std::size_t first, std::size_t last) {
        place_vertices(axes, face, &mesh.corner[first], last - first, &mesh.place[first]);
    });
}

void project_through_face(
    const CubeFace& face, const SampleBounds& bounds, PencilMesh& mesh, Tasks& tasks)
{
    project_all_vertices_to_face(face, mesh, tasks);
    tasks.for_each(mesh.range_count.size(),
        [&](std::size_t range, std::size_t) { see_range(range, bounds, mesh); });
}

} // namespace firsthit
