// facets.h - normals of flat triangles and polygons.
#pragma once

#include <glm/vec3.hpp>

#include <span>

namespace firsthit::aff {

/// The unit normal of a closed polygon, counter-clockwise = front; (0, 0, 1) where it has no area.
///
/// source  Newell's method (Sutherland, Sproull and Schumacker 1974)
glm::vec3 flat_normal(std::span<const glm::vec3> corners);

/// `normal` with unit length, or `other` where it has none.
glm::vec3 unit_or(const glm::vec3& normal, const glm::vec3& other);

} // namespace firsthit::aff
