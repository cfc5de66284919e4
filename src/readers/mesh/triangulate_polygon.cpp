// triangulate_polygon.cpp - cuts a polygon of any outline into triangles.
#include "readers/mesh/triangulate_polygon.h"

#include "readers/mesh/ear_clipper.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace firsthit {
namespace {

/// Twice the polygon's area, along its normal. NaN or infinite where a corner is.
glm::dvec3 newell_normal(std::span<const glm::vec3> corner)
{
    const glm::dvec3 origin(corner[0]); // so that a polygon far from the origin loses nothing
    glm::dvec3 sum(0);
    for (std::size_t k = 1; k + 1 < corner.size(); ++k)
        sum += glm::cross(glm::dvec3(corner[k]) - origin, glm::dvec3(corner[k + 1]) - origin);
    return sum;
}

/// Projects along the axis nearest to the normal, so that coordinates stay exact and the polygon runs
/// counter-clockwise.
std::vector<glm::dvec2> project(std::span<const glm::vec3> corner, const glm::dvec3& normal)
{
    const glm::dvec3 size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    int first = (axis + 1) % 3;
    int second = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(first, second);
    std::vector<glm::dvec2> point;
    point.reserve(corner.size());
    for (const glm::vec3& p : corner) point.emplace_back(p[first], p[second]);
    return point;
}

/// Whether no triangle of the fan around the first corner is turned over, seen along the normal. What is
/// thinner than a millionth of its length is not counted: it is what rounding makes of three corners in
/// a line.
bool is_fan(std::span<const glm::vec3> corner, const glm::dvec3& normal)
{
    const double thin = 1e-6 * glm::length(normal);
    const glm::dvec3 origin(corner[0]);
    glm::dvec3 a = glm::dvec3(corner[1]) - origin;
    for (std::size_t k = 2; k < corner.size(); ++k) {
        const glm::dvec3 b = glm::dvec3(corner[k]) - origin;
        const double turned = glm::dot(glm::cross(a, b), normal);
        if (turned < 0 && turned * turned > thin * thin * glm::dot(a, a) * glm::dot(b, b))
            return false;
        a = b;
    }
    return true;
}

} // namespace

bool triangulate_polygon(std::span<const glm::vec3> corner, std::vector<glm::uvec3>& triangles)
{
    const auto add_fan = [&] {
        for (std::uint32_t k = 2; k < corner.size(); ++k) triangles.emplace_back(0u, k - 1, k);
    };
    if (corner.size() == 3) {
        add_fan();
        return true;
    }
    const glm::dvec3 normal = newell_normal(corner);
    const double size = glm::dot(normal, normal);
    if (!(size > 0) || !std::isfinite(size)) {
        add_fan();
        return true;
    }
    if (!is_fan(corner, normal)) return clip_ears(project(corner, normal), triangles);
    add_fan();
    return true;
}

} // namespace firsthit
