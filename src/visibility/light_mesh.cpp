// light_mesh.cpp - the scene's triangles as a light sees them.
#include "visibility/light_mesh.h"

#include "visibility/careful_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace firsthit {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

SeenPoint see_vertex(const LightFace& face, const glm::vec3& p)
{
    if (!usable(p)) return {kNone, 0, 0};
    if (!face.directional && !(face.sign * p[face.axis_c] > 0)) return {kNone, 0, 0};
    return see(face, p);
}

/// A triangle with a corner behind the face, or with one that makes it invisible.
bool see_careful(const LightFace& face, const Corners& corners, SeenTriangle& box)
{
    if (face.directional || !usable(corners)) return false;
    const Corners seen{
        face.seen_from(corners[0]), face.seen_from(corners[1]), face.seen_from(corners[2])};
    if (!(seen[0].z > 0) && !(seen[1].z > 0) && !(seen[2].z > 0)) return false;
    const Interval x = project_front(seen, 0), y = project_front(seen, 1);
    // Rounded to double and to float: the samples' bounds are within 1.
    constexpr float kMargin = 0x1p-20f;
    box.x0 = float(x.low) - kMargin, box.x1 = float(x.high) + kMargin;
    box.y0 = float(y.low) - kMargin, box.y1 = float(y.high) + kMargin;
    box.nearest_w = std::numeric_limits<float>::infinity();
    return true;
}

/// Keeps the triangles of one range that overlap the samples' bounds.
void see_range(std::size_t range, const SampleBounds& bounds, LightMesh& mesh)
{
    const std::size_t first = range * kLightRange,
                      last = std::min(mesh.index.size(), first + kLightRange);
    SeenTriangle* kept = &mesh.in_view[first];
    for (std::size_t t = first; t < last; ++t) {
        const glm::uvec3& corner = mesh.index[t];
        const SeenPoint &a = mesh.seen[corner.x], &b = mesh.seen[corner.y],
                        &c = mesh.seen[corner.z];
        SeenTriangle box{std::uint32_t(t), std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}),
            std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.w, b.w, c.w})};
        const float sum = (a.x + b.x) + c.x;
        if (sum != sum) [[unlikely]] {
            if (!see_careful(mesh.face, mesh.corners(box.triangle), box)) continue;
        }
        *kept = box;
        kept += may_shadow(box, bounds);
    }
    mesh.range_count[range] = std::uint32_t(kept - &mesh.in_view[first]);
}

} // namespace

void see_from_light(const LightSpace& space, std::span<const glm::vec3> position,
    std::span<const glm::uvec3> index, LightMesh& mesh, Tasks& tasks)
{
    mesh.space = space;
    mesh.index = index;
    mesh.corner.resize(position.size());
    mesh.seen.resize(position.size());
    mesh.in_view.resize(index.size() + 1);
    mesh.range_count.resize((index.size() + kLightRange - 1) / kLightRange);
    tasks.for_ranges(position.size(), kLightRange, [&](std::size_t first, std::size_t last) {
        for (std::size_t v = first; v < last; ++v) mesh.corner[v] = to_light(space, position[v]);
    });
}

void see_through_face(
    const LightFace& face, const SampleBounds& bounds, LightMesh& mesh, Tasks& tasks)
{
    mesh.face = face;
    tasks.for_ranges(mesh.corner.size(), kLightRange, [&](std::size_t first, std::size_t last) {
        for (std::size_t v = first; v < last; ++v) mesh.seen[v] = see_vertex(face, mesh.corner[v]);
    });
    tasks.for_each(mesh.range_count.size(),
        [&](std::size_t range, std::size_t) { see_range(range, bounds, mesh); });
}

} // namespace firsthit
