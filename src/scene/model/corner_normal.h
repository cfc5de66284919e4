// corner_normal.h - what a triangle adds to the normals of its corners.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace firsthit {

/// In double: products of six coordinates stay far from overflow.
struct TriangleEdges {
    glm::dvec3 edge[3]; // edge[k] from corner k to corner k + 1
    glm::dvec3 cross;   // twice the area along the normal
};

inline TriangleEdges triangle_edges(std::span<const glm::vec3> position, const glm::uvec3& corners)
{
    const glm::dvec3 a(position[corners.x]);
    const glm::dvec3 b(position[corners.y]);
    const glm::dvec3 c(position[corners.z]);
    return {{b - a, c - b, a - c}, glm::cross(b - a, c - b)};
}

/// Max's weighted normal at a corner: sine over the lengths of both edges, times the unit normal.
/// source  Max 1999, "Weights for Computing Vertex Normals from Facet Normals", JGT 4(2)
inline glm::dvec3 corner_normal(const TriangleEdges& triangle, int corner)
{
    const glm::dvec3& out = triangle.edge[corner];
    const glm::dvec3& in = triangle.edge[(corner + 2) % 3];
    const double lengths = glm::dot(out, out) * glm::dot(in, in);
    return lengths > 0 ? triangle.cross / lengths : glm::dvec3(0);
}

/// The unit normal along a sum of such; +z where there is none.
inline glm::vec3 unit_normal(const glm::dvec3& sum)
{
    const double largest = std::max({std::abs(sum.x), std::abs(sum.y), std::abs(sum.z)});
    if (!(largest > 0)) return {0, 0, 1};
    return glm::vec3(glm::normalize(sum / largest));
}

} // namespace firsthit
