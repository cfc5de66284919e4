// facets.cpp - normals of flat triangles and polygons.
#include "readers/aff/facets.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>

namespace firsthit::aff {

glm::vec3 flat_normal(std::span<const glm::vec3> corners)
{
    // Relative to the first corner, so that a polygon far from the origin loses nothing.
    const glm::dvec3 origin(corners[0]);
    glm::dvec3 normal(0);
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        normal += glm::cross(glm::dvec3(corners[k]) - origin, glm::dvec3(corners[k + 1]) - origin);
    const double length = glm::length(normal);
    return length > 0 ? glm::vec3(normal / length) : glm::vec3(0, 0, 1);
}

glm::vec3 unit_or(const glm::vec3& normal, const glm::vec3& other)
{
    const glm::dvec3 wide(normal);
    const double length = glm::length(wide);
    return length > 0 ? glm::vec3(wide / length) : other;
}

} // namespace firsthit::aff
