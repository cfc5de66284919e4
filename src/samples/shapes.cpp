// shapes.cpp - rounded solids, made of triangles with smooth normals.
#include "samples/shapes.h"

#include "samples/trigonometry.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firsthit {
namespace {

void add_vertex(
    Shape& shape, const glm::dmat4& shape_from_solid, const glm::dvec3& p, const glm::dvec3& n)
{
    shape.position.emplace_back(shape_from_solid * glm::dvec4(p, 1));
    shape.normal.emplace_back(glm::normalize(glm::dmat3(shape_from_solid) * n));
}

/// Joins the vertices of a grid, rows from the top to the bottom, columns counter-clockwise seen
/// from above; the last column is joined to the first.
void join_grid(Shape& shape, std::uint32_t first, std::uint32_t rows, std::uint32_t columns)
{
    for (std::uint32_t r = 0; r + 1 < rows; ++r)
        for (std::uint32_t c = 0; c < columns; ++c) {
            const std::uint32_t next = (c + 1) % columns;
            const std::uint32_t a = first + r * columns + c;
            const std::uint32_t b = a + columns;
            const std::uint32_t d = first + r * columns + next;
            const std::uint32_t e = d + columns;
            add_triangle(shape, a, b, e);
            add_triangle(shape, a, e, d);
        }
}

/// The direction at an angle around y, counter-clockwise seen from above.
glm::dvec3 around(double angle)
{
    return {cosine(angle), 0, -sine(angle)};
}

glm::dvec2 outward(const Outline& a, const Outline& b)
{
    const glm::dvec2 along(b.radius - a.radius, b.y - a.y);
    const double length = glm::length(along);
    return length > 0 ? glm::dvec2(-along.y, along.x) / length : glm::dvec2(0);
}

} // namespace

void add_triangle(Shape& shape, std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    const glm::dvec3 pa(shape.position[a]);
    const glm::dvec3 pb(shape.position[b]);
    const glm::dvec3 pc(shape.position[c]);
    if (glm::length(glm::cross(pb - pa, pc - pa)) > 1e-9) shape.index.emplace_back(a, b, c);
}

glm::dmat4 moved(double x, double y, double z)
{
    return glm::translate(glm::dmat4(1), glm::dvec3(x, y, z));
}

glm::dmat4 moved(double x, double y, double z, const glm::dvec3& axis, double angle_rad)
{
    const auto [s, c] = sine_cosine(angle_rad);
    const glm::dvec3 n = glm::normalize(axis);
    glm::dmat3 turn(1);
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 unit = turn[k];
        turn[k] = c * unit + s * glm::cross(n, unit) + (1 - c) * n[k] * n;
    }
    glm::dmat4 result(turn);
    result[3] = glm::dvec4(x, y, z, 1);
    return result;
}

void add_lathe(Shape& shape, std::span<const Outline> outline, int segments,
    const glm::dmat4& shape_from_solid)
{
    const auto first = static_cast<std::uint32_t>(shape.position.size());
    for (std::size_t i = 0; i < outline.size(); ++i) {
        // The mean of both neighbours' normals; at a crease one of them has no length.
        glm::dvec2 normal(0);
        if (i > 0) normal += outward(outline[i - 1], outline[i]);
        if (i + 1 < outline.size()) normal += outward(outline[i], outline[i + 1]);
        for (int s = 0; s < segments; ++s) {
            const glm::dvec3 out = around(2 * std::numbers::pi * s / segments);
            add_vertex(shape, shape_from_solid,
                out * outline[i].radius + glm::dvec3(0, outline[i].y, 0),
                out * normal.x + glm::dvec3(0, normal.y, 0));
        }
    }
    join_grid(shape, first, static_cast<std::uint32_t>(outline.size()),
        static_cast<std::uint32_t>(segments));
}

void add_ellipsoid(
    Shape& shape, const glm::dvec3& radius, int segments, const glm::dmat4& shape_from_solid)
{
    const auto first = static_cast<std::uint32_t>(shape.position.size());
    const int rows = std::max(2, segments / 2);
    for (int r = 0; r <= rows; ++r) {
        // Exactly zero at the poles, where sin(pi) is not.
        const double ring = r == 0 || r == rows ? 0.0 : sine(std::numbers::pi * r / rows);
        const double y = cosine(std::numbers::pi * r / rows);
        for (int s = 0; s < segments; ++s) {
            const glm::dvec3 n =
                around(2 * std::numbers::pi * s / segments) * ring + glm::dvec3(0, y, 0);
            add_vertex(shape, shape_from_solid, n * radius, n / radius);
        }
    }
    join_grid(
        shape, first, static_cast<std::uint32_t>(rows + 1), static_cast<std::uint32_t>(segments));
}

void add_rounded_box(Shape& shape, const glm::dvec3& half, double rounding, int segments,
    const glm::dmat4& shape_from_solid, double taper)
{
    // An eighth of a sphere in every corner; the faces between are what joins them.
    const auto first = static_cast<std::uint32_t>(shape.position.size());
    const glm::dvec3 inner = half - rounding;
    for (const double top : {1.0, -1.0})
        for (int r = 0; r <= segments; ++r) {
            const double step = static_cast<double>(r) / segments;
            const double tilt = std::numbers::pi / 2 * (top > 0 ? step : 1 + step);
            const double y = cosine(tilt);
            for (int quarter = 0; quarter < 4; ++quarter)
                for (int s = 0; s <= segments; ++s) {
                    const double turn =
                        std::numbers::pi / 2 * (quarter + static_cast<double>(s) / segments);
                    const glm::dvec3 n = around(turn) * sine(tilt) + glm::dvec3(0, y, 0);
                    const glm::dvec3 corner = around(std::numbers::pi / 2 * (quarter + 0.5));
                    const glm::dvec3 sign(corner.x > 0 ? 1 : -1, top, corner.z > 0 ? 1 : -1);
                    glm::dvec3 p = n * rounding + sign * inner;
                    const double width = taper + (1 - taper) * (p.y / half.y + 1) / 2;
                    p.x *= width;
                    p.z *= width;
                    // Of a side that leans: it looks up or down as the width changes with y.
                    const double slope = (1 - taper) / (2 * half.y);
                    const double reach = std::abs(n.x) * half.x + std::abs(n.z) * half.z;
                    add_vertex(shape, shape_from_solid, p, n - glm::dvec3(0, slope * reach, 0));
                }
        }
    const auto columns = static_cast<std::uint32_t>(4 * (segments + 1));
    const auto rows = static_cast<std::uint32_t>(2 * (segments + 1));
    join_grid(shape, first, rows, columns);

    // Top and bottom: between the four corners.
    const auto quarter = static_cast<std::uint32_t>(segments + 1);
    const std::uint32_t last = first + (rows - 1) * columns;
    add_triangle(shape, first, first + quarter, first + 2 * quarter);
    add_triangle(shape, first, first + 2 * quarter, first + 3 * quarter);
    add_triangle(shape, last, last + 2 * quarter, last + quarter);
    add_triangle(shape, last, last + 3 * quarter, last + 2 * quarter);
}

} // namespace firsthit
