// triangle_box.h - the box of samples that a triangle may hit.
#pragma once

#include "visibility/bin/careful_box.h"
#include "visibility/bin/eye_mesh.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace firsthit {

/// A vertex in eye space, for both CornerSpaces. It has rounding errors if it is stored flat.
inline glm::vec3 eye_corner(const EyeMesh& mesh, std::uint32_t vertex)
{
    const glm::vec4& v = mesh.corner[vertex];
    const bool is_eye = mesh.corner_space == CornerSpace::eye ||
                        std::bit_cast<VertexSamples>(v.w).x == VertexSamples::kBehind;
    return is_eye ? glm::vec3(v) : glm::vec3(v.x / v.z, v.y / v.z, 1 / v.z);
}

/// A lower bound of the depths z of a triangle whose corners are all in front of the eye.
///
/// vertices  of the triangle: its element of EyeMesh::index
inline float nearest_z(const EyeMesh& mesh, const glm::uvec3& vertices)
{
    const auto z = [&](std::uint32_t vertex) { return mesh.corner[vertex].z; };
    if (mesh.corner_space == CornerSpace::eye)
        return std::min({z(vertices.x), z(vertices.y), z(vertices.z)});
    // The factor covers the two roundings of 1 / (1/z).
    return (1 - 0x1p-20f) / std::max({z(vertices.x), z(vertices.y), z(vertices.z)});
}

/// Finds a box that holds all samples of the pencil that a triangle may hit. Returns false, and
/// leaves the box alone, if it can hit none.
inline bool box_of(std::uint32_t triangle, const EyeMesh& mesh, const Pencil& pencil, InView& box)
{
    const glm::uvec3& vertices = mesh.index[triangle];
    const auto samples = [&](std::uint32_t vertex) {
        return std::bit_cast<VertexSamples>(mesh.corner[vertex].w);
    };
    const VertexSamples a = samples(vertices.x), b = samples(vertices.y), c = samples(vertices.z);
    const std::int16_t least_x = std::min({a.x, b.x, c.x});
    if (least_x == VertexSamples::kBehind) [[unlikely]] {
        // Of parallel rays, what has no corner in front of the eye is not seen. Other rays leave this to
        // careful_box.
        if (pencil.parallel && a.x == b.x && b.x == c.x) return false;
        const auto found = careful_box(triangle,
            {eye_corner(mesh, vertices.x), eye_corner(mesh, vertices.y),
                eye_corner(mesh, vertices.z)},
            pencil);
        if (found) box = *found;
        return found.has_value();
    }
    const int x0 = VertexSamples::first(least_x),
              y0 = VertexSamples::first(std::min({a.y, b.y, c.y}));
    const int x1 = VertexSamples::last(std::max({a.x, b.x, c.x}));
    const int y1 = VertexSamples::last(std::max({a.y, b.y, c.y}));
    if (x0 > x1 || y0 > y1) return false;
    box = {triangle, std::int16_t(x0), std::int16_t(y0), std::int16_t(x1), std::int16_t(y1),
        nearest_z(mesh, vertices)};
    return true;
}

} // namespace firsthit
