// tangents.cpp - tangents of meshes that bring none.
#include "scene/model/tangents.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace firsthit {
namespace {

/// Unit; 0 where that is nothing.
glm::dvec3 unit(const glm::dvec3& v)
{
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : glm::dvec3(0);
}

/// Any unit vector at right angles to n.
glm::dvec3 across(const glm::dvec3& n)
{
    const glm::dvec3 axis = std::abs(n.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 t = unit(axis - n * glm::dot(n, axis));
    return glm::dot(t, t) > 0 ? t : glm::dvec3(1, 0, 0);
}

/// The ways in which u and v grow over a triangle, unit; 0 where its texture has no area.
struct Frame {
    glm::dvec3 tangent{0}, bitangent{0};
};

Frame frame_of(const std::array<glm::dvec3, 3>& p, const std::array<glm::dvec2, 3>& uv)
{
    const glm::dvec3 e1 = p[1] - p[0], e2 = p[2] - p[0];
    const glm::dvec2 d1 = uv[1] - uv[0], d2 = uv[2] - uv[0];
    const double area = d1.x * d2.y - d2.x * d1.y;
    if (area == 0) return {};
    const double sign = area > 0 ? 1 : -1; // lengths do not count
    return {unit((e1 * d2.y - e2 * d1.y) * sign), unit((e2 * d1.x - e1 * d2.x) * sign)};
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

} // namespace

std::vector<glm::vec4> derived_tangents(
    const Mesh& mesh, const std::vector<glm::vec2>& uv, const glm::mat3x2& transform)
{
    std::vector<Frame> sum(mesh.position.size());
    std::vector<glm::dvec3> facing(mesh.normal.empty() ? mesh.position.size() : 0);
    for (const glm::uvec3& corner : mesh.index) {
        std::array<glm::dvec3, 3> p;
        std::array<glm::dvec2, 3> at;
        for (int k = 0; k < 3; ++k) {
            const auto v = std::size_t(corner[k]);
            p[std::size_t(k)] = mesh.position[v];
            at[std::size_t(k)] = glm::dmat3x2(transform) * glm::dvec3(uv[v], 1.0);
        }
        const Frame frame = frame_of(p, at);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto v = std::size_t(corner[int(k)]);
            const glm::dvec3 next = p[(k + 1) % 3] - p[k], last = p[(k + 2) % 3] - p[k];
            const double angle = angle_between(next, last);
            // Along the vertex's own plane, so that a steep triangle counts no less than a flat one.
            const glm::dvec3 n =
                unit(mesh.normal.empty() ? glm::cross(next, last) : glm::dvec3(mesh.normal[v]));
            const auto flat = [&](const glm::dvec3& d) { return unit(d - n * glm::dot(n, d)); };
            sum[v].tangent += angle * flat(frame.tangent);
            sum[v].bitangent += angle * flat(frame.bitangent);
            if (mesh.normal.empty()) facing[v] += angle * n;
        }
    }
    std::vector<glm::vec4> tangents;
    tangents.reserve(sum.size());
    for (std::size_t v = 0; v < sum.size(); ++v) {
        const glm::dvec3 n = unit(mesh.normal.empty() ? facing[v] : glm::dvec3(mesh.normal[v]));
        glm::dvec3 t = unit(sum[v].tangent - n * glm::dot(n, sum[v].tangent));
        if (glm::dot(t, t) == 0) t = across(n);
        const bool mirrored = glm::dot(glm::cross(n, t), sum[v].bitangent) < 0;
        tangents.emplace_back(glm::vec3(t), mirrored ? -1.0f : 1.0f);
    }
    return tangents;
}

} // namespace firsthit
