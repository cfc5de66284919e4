// facets.cpp - meshes whose triangles are flat.
#include "scene/model/facets.h"

#include "scene/model/corner_normal.h"

#include <span>

namespace firsthit {
namespace {

/// The values of all corners; nothing where there are none. each: values of a vertex.
template <class T>
void spread(const std::vector<glm::uvec3>& index, std::vector<T>& values, std::size_t each = 1)
{
    if (values.empty()) return;
    std::vector<T> corners;
    corners.reserve(index.size() * 3 * each);
    for (const glm::uvec3& triangle : index)
        for (int k = 0; k < 3; ++k)
            for (std::size_t e = 0; e < each; ++e)
                corners.push_back(values[each * triangle[k] + e]);
    values = std::move(corners);
}

} // namespace

void make_facets(Mesh& mesh)
{
    spread(mesh.index, mesh.position);
    spread(mesh.index, mesh.uv);
    spread(mesh.index, mesh.uv1);
    spread(mesh.index, mesh.color);
    spread(mesh.index, mesh.tangent);
    for (MorphTarget& target : mesh.shape.targets) {
        spread(mesh.index, target.position);
        spread(mesh.index, target.normal);
        spread(mesh.index, target.tangent);
    }
    const auto influences = static_cast<std::size_t>(mesh.shape.skin.influences);
    spread(mesh.index, mesh.shape.skin.joint, influences);
    spread(mesh.index, mesh.shape.skin.weight, influences);

    mesh.normal.clear();
    mesh.normal.reserve(mesh.position.size());
    for (std::uint32_t t = 0; t < mesh.index.size(); ++t) {
        mesh.index[t] = glm::uvec3(3 * t, 3 * t + 1, 3 * t + 2);
        const std::span<const glm::vec3> corners(&mesh.position[3 * std::size_t(t)], 3);
        const glm::uvec3 first(0, 1, 2);
        const TriangleEdges edges = triangle_edges(corners, first);
        for (int k = 0; k < 3; ++k) mesh.normal.push_back(unit_normal(corner_normal(edges, k)));
    }
}

} // namespace firsthit
