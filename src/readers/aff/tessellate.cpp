// tessellate.cpp - spheres and cones as triangles.
#include "readers/aff/tessellate.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace firsthit::aff {
namespace {

/// Cosine and sine of `segments` equal steps around a circle.
std::vector<glm::dvec2> circle(int segments)
{
    std::vector<glm::dvec2> points;
    for (int k = 0; k < segments; ++k) {
        const double angle = 2 * std::numbers::pi * k / segments;
        points.emplace_back(std::cos(angle), std::sin(angle));
    }
    return points;
}

void add_vertex(Facets& facets, const glm::dvec3& position, const glm::dvec3& normal)
{
    facets.position.emplace_back(position);
    facets.normal.emplace_back(normal);
}

/// The band between two rings of vertices, whose numbers start at `low` and `high`. A ring that is
/// a single point repeats its vertex or not; its triangles without area are left out.
struct Band {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    bool low_is_point = false; // in space
    bool high_is_point = false;
    bool high_is_one_vertex = false;
    bool low_is_one_vertex = false;
};

void add_band(Facets& facets, const Band& band, int segments)
{
    const auto count = static_cast<std::uint32_t>(segments);
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t next = (k + 1) % count;
        const std::uint32_t low = band.low + (band.low_is_one_vertex ? 0 : k);
        const std::uint32_t low_next = band.low + (band.low_is_one_vertex ? 0 : next);
        const std::uint32_t high = band.high + (band.high_is_one_vertex ? 0 : k);
        const std::uint32_t high_next = band.high + (band.high_is_one_vertex ? 0 : next);
        if (!band.low_is_point) facets.triangle.emplace_back(low, low_next, high_next);
        if (!band.high_is_point) facets.triangle.emplace_back(low, high_next, high);
    }
}

void turn_inside_out(Facets& facets)
{
    for (glm::vec3& normal : facets.normal) normal = -normal;
    for (glm::uvec3& triangle : facets.triangle) std::swap(triangle.y, triangle.z);
}

} // namespace

Facets tessellate_sphere(const glm::dvec3& center, double radius, int segments)
{
    const std::vector<glm::dvec2> around = circle(segments);
    const int bands = std::max(2, segments / 2); // one alone has no ring between the poles
    Facets facets;

    // From the north pole down: one vertex, rings, one vertex.
    const double r = std::abs(radius);
    const glm::dvec3 north(0, 1, 0);
    add_vertex(facets, center + r * north, north);
    for (int ring = 1; ring < bands; ++ring) {
        const double angle = std::numbers::pi * ring / bands;
        for (const glm::dvec2& c : around) {
            const glm::dvec3 out(std::sin(angle) * c.y, std::cos(angle), std::sin(angle) * c.x);
            add_vertex(facets, center + r * out, out);
        }
    }
    add_vertex(facets, center - r * north, -north);

    for (int band = 0; band < bands; ++band) {
        const bool top = band == 0;
        const bool bottom = band == bands - 1;
        const auto first = static_cast<std::uint32_t>(1 + band * segments);
        add_band(facets,
            {.low = first,
                .high = top ? 0 : first - static_cast<std::uint32_t>(segments),
                .low_is_point = bottom,
                .high_is_point = top,
                .high_is_one_vertex = top,
                .low_is_one_vertex = bottom},
            segments);
    }
    if (radius < 0) turn_inside_out(facets);
    return facets;
}

Facets tessellate_cone(const Cone& cone, int segments)
{
    // A right-handed frame (right, ahead, axis).
    const glm::dvec3 span = cone.apex - cone.base;
    const double height = glm::length(span);
    const glm::dvec3 axis = span / height;
    const glm::dvec3 side = std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(side, axis));
    const glm::dvec3 ahead = glm::cross(axis, right);

    // Normals lean towards the narrow end; a tip has one for each segment.
    const double base_radius = std::abs(cone.base_radius);
    const double apex_radius = std::abs(cone.apex_radius);
    Facets facets;
    if (base_radius == 0 && apex_radius == 0) return facets;
    const std::vector<glm::dvec2> around = circle(segments);
    for (const bool apex : {false, true})
        for (const glm::dvec2& c : around) {
            const glm::dvec3 out = c.x * right + c.y * ahead;
            const glm::dvec3 normal =
                glm::normalize(height * out + (base_radius - apex_radius) * axis);
            add_vertex(facets, apex ? cone.apex + apex_radius * out : cone.base + base_radius * out,
                normal);
        }
    add_band(facets,
        {.low = 0,
            .high = static_cast<std::uint32_t>(segments),
            .low_is_point = base_radius == 0,
            .high_is_point = apex_radius == 0},
        segments);
    if (cone.base_radius < 0 || cone.apex_radius < 0) turn_inside_out(facets);
    return facets;
}

} // namespace firsthit::aff
