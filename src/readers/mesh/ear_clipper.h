// ear_clipper.h - cuts a polygon of the plane into triangles, an ear at a time.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace firsthit {

/// Cuts off ears: corners whose triangle with both neighbours holds nothing of the outline. Those that
/// were found first go first, which keeps triangles from getting thin. All decisions are exact.
///
/// point      (n), n >= 3, counter-clockwise; coordinates are finite floats
/// triangles  n - 2 are appended: numbers of points
/// returns    false where a corner had to be cut off that is no ear: the outline crosses itself
bool clip_ears(std::span<const glm::dvec2> point, std::vector<glm::uvec3>& triangles);

} // namespace firsthit
