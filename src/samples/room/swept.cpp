// swept.cpp - tubes along paths, sheets over grids and sharp boxes.
#include "samples/room/swept.h"

#include "samples/trigonometry.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <cstddef>
#include <numbers>

namespace firsthit {
namespace {

std::uint32_t vertex_number(const Shape& shape)
{
    return static_cast<std::uint32_t>(shape.position.size());
}

void add_point(
    Shape& shape, const glm::dmat4& shape_from_solid, const glm::dvec3& p, const glm::dvec3& normal)
{
    shape.position.emplace_back(shape_from_solid * glm::dvec4(p, 1));
    shape.normal.emplace_back(glm::normalize(glm::dmat3(shape_from_solid) * normal));
}

/// A cross section of a tube.
struct Section {
    glm::dvec3 middle{0}, along{0}, first{0}, second{0};
    double radius = 0;

    glm::dvec3 outward(int side, int sides) const
    {
        const auto [s, c] = sine_cosine(2 * std::numbers::pi * side / sides);
        return c * first + s * second;
    }
};

std::vector<Section> sections_of(std::span<const TubePoint> path, const TubeStyle& style)
{
    const std::size_t count = path.size();
    std::vector<Section> sections(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t before = i > 0 ? i - 1 : style.ring ? count - 1 : 0;
        const std::size_t after = i + 1 < count ? i + 1 : style.ring ? 0 : count - 1;
        Section& section = sections[i];
        section.middle = path[i].place;
        section.radius = path[i].radius;
        section.along = glm::normalize(path[after].place - path[before].place);
        section.first =
            glm::normalize(style.across - section.along * glm::dot(style.across, section.along));
        section.second = glm::cross(section.along, section.first);
    }
    return sections;
}

/// A flat end that looks along `normal`.
void add_cap(
    Shape& shape, const Section& section, int sides, bool front, const glm::dmat4& shape_from_solid)
{
    const glm::dvec3 normal = front ? -section.along : section.along;
    const std::uint32_t middle = vertex_number(shape);
    add_point(shape, shape_from_solid, section.middle, normal);
    for (int s = 0; s < sides; ++s)
        add_point(shape, shape_from_solid,
            section.middle + section.radius * section.outward(s, sides), normal);
    for (int s = 0; s < sides; ++s) {
        const auto a = middle + 1 + static_cast<std::uint32_t>(s);
        const auto b = middle + 1 + static_cast<std::uint32_t>((s + 1) % sides);
        if (front)
            add_triangle(shape, middle, b, a);
        else
            add_triangle(shape, middle, a, b);
    }
}

} // namespace

void add_tube(Shape& shape, std::span<const TubePoint> path, const TubeStyle& style,
    const glm::dmat4& shape_from_solid)
{
    const std::vector<Section> sections = sections_of(path, style);
    const std::uint32_t first = vertex_number(shape);
    for (const Section& section : sections)
        for (int s = 0; s < style.sides; ++s) {
            const glm::dvec3 out = section.outward(s, style.sides);
            add_point(shape, shape_from_solid, section.middle + section.radius * out, out);
        }
    const auto sides = static_cast<std::uint32_t>(style.sides);
    const auto count = static_cast<std::uint32_t>(sections.size());
    for (std::uint32_t i = 0; i + 1 < count + (style.ring ? 1 : 0); ++i)
        for (std::uint32_t s = 0; s < sides; ++s) {
            const std::uint32_t here = first + i * sides, there = first + (i + 1) % count * sides;
            const std::uint32_t next = (s + 1) % sides;
            add_triangle(shape, here + s, here + next, there + next);
            add_triangle(shape, here + s, there + next, there + s);
        }
    if (style.ring) return;
    add_cap(shape, sections.front(), style.sides, true, shape_from_solid);
    add_cap(shape, sections.back(), style.sides, false, shape_from_solid);
}

void add_rod(Shape& shape, const glm::dvec3& from, const glm::dvec3& to, double radius, int sides)
{
    const glm::dvec3 way = glm::abs(to - from);
    const glm::dvec3 across =
        way.y > way.x && way.y > way.z ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    add_tube(shape, std::to_array<TubePoint>({{from, radius}, {to, radius}}),
        {.sides = sides, .across = across});
}

std::vector<TubePoint> sample_path(
    int steps, double radius, const std::function<glm::dvec3(double u)>& place)
{
    std::vector<TubePoint> path;
    for (int k = 0; k <= steps; ++k)
        path.push_back({place(static_cast<double>(k) / steps), radius});
    return path;
}

std::vector<glm::vec2> add_sheet(
    Shape& shape, int columns, int rows, const std::function<glm::dvec3(double u, double v)>& place)
{
    const int width = columns + 1;
    std::vector<glm::dvec3> grid;
    std::vector<glm::vec2> uv;
    for (int r = 0; r <= rows; ++r)
        for (int c = 0; c <= columns; ++c) {
            const double u = static_cast<double>(c) / columns, v = static_cast<double>(r) / rows;
            grid.push_back(place(u, v));
            uv.emplace_back(u, v);
        }
    const auto at = [&](int c, int r) {
        return grid[static_cast<std::size_t>(
            glm::clamp(r, 0, rows) * width + glm::clamp(c, 0, columns))];
    };
    const std::uint32_t first = vertex_number(shape);
    for (int r = 0; r <= rows; ++r)
        for (int c = 0; c <= columns; ++c)
            add_point(shape, glm::dmat4(1), at(c, r),
                glm::cross(at(c + 1, r) - at(c - 1, r), at(c, r + 1) - at(c, r - 1)));
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            const std::uint32_t a = first + static_cast<std::uint32_t>(r * width + c);
            const std::uint32_t b = a + static_cast<std::uint32_t>(width);
            add_triangle(shape, a, a + 1, b + 1);
            add_triangle(shape, a, b + 1, b);
        }
    return uv;
}

void add_box(Shape& shape, const glm::dvec3& half, const glm::dmat4& shape_from_solid)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 normal(0), u(0), v(0);
            normal[axis] = side;
            u[(axis + 1) % 3] = side;
            v[(axis + 2) % 3] = 1;
            const std::uint32_t first = vertex_number(shape);
            for (const glm::dvec2 corner :
                {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)})
                add_point(
                    shape, shape_from_solid, half * (normal + corner.x * u + corner.y * v), normal);
            add_triangle(shape, first, first + 1, first + 2);
            add_triangle(shape, first, first + 2, first + 3);
        }
}

std::vector<glm::vec2> box_mapping(const Shape& shape, double size, bool turned)
{
    std::vector<glm::vec2> uv;
    uv.reserve(shape.position.size());
    const auto scale = static_cast<float>(1 / size);
    for (std::size_t k = 0; k < shape.position.size(); ++k) {
        const glm::vec3 p = shape.position[k] * scale, n = glm::abs(shape.normal[k]);
        if (n.y >= n.x && n.y >= n.z)
            uv.push_back(turned ? glm::vec2(p.z, p.x) : glm::vec2(p.x, p.z));
        else if (n.x >= n.z)
            uv.emplace_back(p.z, p.y);
        else
            uv.emplace_back(p.x, p.y);
    }
    return uv;
}

} // namespace firsthit
