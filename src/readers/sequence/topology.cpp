// topology.cpp - which vertices the triangles of a frame join, and whether two frames are alike in that.
#include "readers/sequence/topology.h"

#include "readers/mesh/weld.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>

namespace firsthit {
namespace {

/// Polygons of more triangles that are cut in another way count as another topology. A guard: it bounds how
/// long unlike frames are compared, and that they are not taken for alike by chance.
constexpr std::size_t kMostCut = 64;

/// Whether triangles have a vertex in common.
bool share_vertices(const Topology& corners)
{
    std::uint32_t largest = 0;
    for (const glm::uvec3& triangle : corners)
        largest = std::max({largest, triangle.x, triangle.y, triangle.z});
    std::vector<bool> used(std::size_t(largest) + 1, false);
    for (const glm::uvec3& triangle : corners) {
        for (int k = 0; k < 3; ++k)
            if (used[triangle[k]]) return true;
        for (int k = 0; k < 3; ++k) used[triangle[k]] = true;
    }
    return false;
}

/// The vertices of triangles, in order of their numbers, each once.
std::vector<std::uint32_t> vertices_of(std::span<const glm::uvec3> triangles)
{
    std::vector<std::uint32_t> made;
    for (const glm::uvec3& triangle : triangles)
        for (int k = 0; k < 3; ++k) made.push_back(triangle[k]);
    std::sort(made.begin(), made.end());
    made.erase(std::unique(made.begin(), made.end()), made.end());
    return made;
}

/// How many triangles from one on have the same vertices in both; 0 where these are too many.
std::size_t cut_alike(const Topology& a, const Topology& b, std::size_t first)
{
    const std::size_t most = std::min(kMostCut, a.size() - first);
    for (std::size_t count = 1; count <= most; ++count)
        if (vertices_of(std::span(a).subspan(first, count)) ==
            vertices_of(std::span(b).subspan(first, count)))
            return count;
    return 0;
}

} // namespace

Topology topology_of(const Scene& scene, std::vector<glm::uvec3> corners)
{
    if (corners.empty()) corners = scene.index;
    if (share_vertices(corners)) return corners;
    std::vector<glm::vec3> position;
    position.reserve(3 * scene.index.size());
    for (const glm::uvec3& triangle : scene.index)
        for (int k = 0; k < 3; ++k) position.push_back(scene.position[triangle[k]]);
    Tasks alone(1); // frames are read on a thread of their own
    const Welded welded = weld(std::span<const glm::vec3>(position), alone);
    for (std::size_t t = 0; t < corners.size(); ++t)
        corners[t] = {welded.number[3 * t], welded.number[3 * t + 1], welded.number[3 * t + 2]};
    return corners;
}

std::optional<CornerMap> match(const Topology& a, const Topology& b)
{
    if (a.size() != b.size()) return std::nullopt;
    CornerMap map;
    for (std::size_t t = 0; t < a.size();) {
        if (a[t] == b[t]) {
            ++t;
            continue;
        }
        const std::size_t count = cut_alike(a, b, t);
        if (count == 0) return std::nullopt;
        if (map.corner.empty()) {
            map.corner.resize(3 * a.size());
            std::iota(map.corner.begin(), map.corner.end(), 0u);
        }
        // The first corner in b that has the vertex.
        for (std::size_t ca = 3 * t; ca < 3 * (t + count); ++ca)
            for (std::size_t cb = 3 * t; cb < 3 * (t + count); ++cb)
                if (a[ca / 3][static_cast<int>(ca % 3)] == b[cb / 3][static_cast<int>(cb % 3)]) {
                    map.corner[ca] = static_cast<std::uint32_t>(cb);
                    break;
                }
        t += count;
    }
    return map;
}

} // namespace firsthit
