// smooth_normals.cpp - normals for triangles that came without.
#include "scene/model/smooth_normals.h"

#include "scene/model/corner_normal.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace firsthit {
namespace {

SmoothNormals all_smooth(std::span<const glm::vec3> position, std::span<const glm::uvec3> index)
{
    std::vector<glm::dvec3> sum(position.size(), glm::dvec3(0));
    SmoothNormals made;
    made.one_a_point = true;
    made.corner.reserve(index.size() * 3);
    for (const glm::uvec3& corners : index) {
        const TriangleEdges triangle = triangle_edges(position, corners);
        for (int k = 0; k < 3; ++k) {
            sum[corners[k]] += corner_normal(triangle, k);
            made.corner.push_back(corners[k]);
        }
    }
    made.normal.reserve(sum.size());
    for (const glm::dvec3& s : sum) made.normal.push_back(unit_normal(s));
    return made;
}

/// Corners (3 * triangle + k) that share a normal point to a common root.
class Groups {
  public:
    explicit Groups(std::size_t corners) : parent_(corners)
    {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::uint32_t root(std::uint32_t corner)
    {
        while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
        return corner;
    }
    /// The lower number becomes the root, so that the result does not depend on the order.
    void join(std::uint32_t a, std::uint32_t b)
    {
        a = root(a);
        b = root(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

/// A triangle's edge, its ends in order.
struct Edge {
    std::uint32_t low, high; // points
    std::uint32_t corner;    // 3 * triangle + k; the edge leaves that corner
};

std::vector<Edge> sorted_edges(std::span<const glm::uvec3> index)
{
    std::vector<Edge> edges;
    edges.reserve(index.size() * 3);
    for (std::size_t t = 0; t < index.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = index[t][k];
            const std::uint32_t b = index[t][(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b),
                static_cast<std::uint32_t>(3 * t + std::size_t(k))});
        }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        if (a.low != b.low) return a.low < b.low;
        if (a.high != b.high) return a.high < b.high;
        return a.corner < b.corner;
    });
    return edges;
}

/// The corner of a triangle at a point, given one end of the edge it leaves from.
std::uint32_t corner_at(std::span<const glm::uvec3> index, const Edge& edge, std::uint32_t point)
{
    const std::uint32_t triangle = edge.corner / 3;
    const std::uint32_t k = edge.corner % 3;
    const bool leaves = index[triangle][static_cast<int>(k)] == point;
    return 3 * triangle + (leaves ? k : (k + 1) % 3);
}

SmoothNormals with_creases(
    std::span<const glm::vec3> position, std::span<const glm::uvec3> index, double crease_angle_rad)
{
    std::vector<glm::dvec3> cross;
    cross.reserve(index.size());
    for (const glm::uvec3& corners : index)
        cross.push_back(triangle_edges(position, corners).cross);

    // Join the corners on both sides of every smooth edge, at both of its ends.
    Groups groups(index.size() * 3);
    const std::vector<Edge> edges = sorted_edges(index);
    const double least_cosine = std::cos(crease_angle_rad);
    for (std::size_t e = 1; e < edges.size(); ++e) {
        const Edge& a = edges[e - 1];
        const Edge& b = edges[e];
        if (a.low != b.low || a.high != b.high) continue;
        const glm::dvec3& na = cross[a.corner / 3];
        const glm::dvec3& nb = cross[b.corner / 3];
        const double lengths = glm::length(na) * glm::length(nb);
        if (!(lengths > 0) || glm::dot(na, nb) < least_cosine * lengths) continue;
        for (const std::uint32_t point : {a.low, a.high})
            groups.join(corner_at(index, a, point), corner_at(index, b, point));
    }

    // Number the groups in order of their first corner and sum their normals.
    SmoothNormals made;
    made.corner.resize(index.size() * 3);
    std::vector<glm::dvec3> sum;
    for (std::uint32_t c = 0; c < made.corner.size(); ++c) {
        const std::uint32_t root = groups.root(c);
        if (root == c) {
            made.corner[c] = static_cast<std::uint32_t>(sum.size());
            sum.emplace_back(0);
        } else {
            made.corner[c] = made.corner[root];
        }
        sum[made.corner[c]] +=
            corner_normal(triangle_edges(position, index[c / 3]), static_cast<int>(c % 3));
    }
    made.normal.reserve(sum.size());
    for (const glm::dvec3& s : sum) made.normal.push_back(unit_normal(s));
    return made;
}

} // namespace

SmoothNormals smooth_normals(
    std::span<const glm::vec3> position, std::span<const glm::uvec3> index, double crease_angle_rad)
{
    // Written so that an angle that is no number is smooth too.
    if (!(crease_angle_rad < std::numbers::pi)) return all_smooth(position, index);
    return with_creases(position, index, std::max(0.0, crease_angle_rad));
}

} // namespace firsthit
