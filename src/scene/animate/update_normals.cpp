// update_normals.cpp - the normals of a world whose positions have changed.
#include "base/tasks.h"
#include "scene/model/corner_normal.h"

#include <firsthit/error.h>
#include <firsthit/normals.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace firsthit {
namespace {

/// Normals of the vertices [first, last). Every range looks at all triangles, in the order of the file: so
/// the sums are the same however vertices are divided, and no list of a vertex's triangles is needed.
void update_range(World& world, std::size_t first, std::size_t last)
{
    const std::size_t count = last - first;
    const std::vector<glm::uvec3>& index = world.scene->index;
    std::fill(world.normal_sum.begin() + std::ptrdiff_t(first),
        world.normal_sum.begin() + std::ptrdiff_t(last), glm::dvec3(0));
    for (std::size_t t = 0; t < index.size(); ++t) {
        const glm::uvec3& corners = index[t];
        // Below `first` the difference wraps around to a large number.
        if (corners.x - first >= count && corners.y - first >= count && corners.z - first >= count)
            continue;
        for (int k = 0; k < 3; ++k)
            if (corners[k] >= world.position.size())
                throw SceneError(
                    fmt::format("{}: triangle {}: vertex {} is out of range ({} exist)",
                        world.scene->name, t, corners[k], world.position.size()));
        const TriangleEdges triangle = triangle_edges(world.position, corners);
        const glm::dvec3& cross = triangle.cross;
        if (!std::isfinite(cross.x + cross.y + cross.z)) continue;
        for (int k = 0; k < 3; ++k)
            if (corners[k] - first < count)
                world.normal_sum[corners[k]] += corner_normal(triangle, k);
    }
    for (std::size_t v = first; v < last; ++v) world.normal[v] = unit_normal(world.normal_sum[v]);
}

} // namespace

void update_normals(World& world, int threads)
{
    if (!world.scene) throw ArgumentError("normals are of a world that was posed before");
    const std::size_t vertices = world.scene->vertices;
    if (world.position.size() != vertices)
        throw ArgumentError(fmt::format("a world with {} positions, its scene has {} vertices",
            world.position.size(), vertices));
    world.normal.resize(vertices);
    world.normal_sum.resize(vertices);
    Tasks tasks(threads);
    const auto ranges = static_cast<std::size_t>(tasks.threads());
    tasks.for_ranges(vertices, (vertices + ranges - 1) / ranges + 1,
        [&](std::size_t first, std::size_t last) { update_range(world, first, last); });
}

} // namespace firsthit
