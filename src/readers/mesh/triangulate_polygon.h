// triangulate_polygon.h - cuts a polygon of any outline into triangles.
#pragma once

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace firsthit {

/// Cuts a polygon of n corners into n - 2 triangles, whose sum it is. Where the fan around the first corner
/// has no triangle that is turned over, it is the fan: (0, 1, 2), (0, 2, 3) and so on, as for every convex
/// polygon. Else ears are clipped in the polygon's own plane, in an order that depends on the
/// corners alone. A polygon without an area, or with a corner that is not finite, is the fan.
///
/// Corners may repeat, lie on one line, or be joined by edges that are passed twice, as those that lead to
/// a hole. Time grows with n log n to n^1.5; a limit proportional to n stops the search for better cuts
/// in outlines that cross themselves often.
///
/// corner     (n), in order, n >= 3; the plane is normal to the sum of the areas (Newell's method)
/// triangles  appended: numbers of corners from 0, with the polygon's orientation
/// returns    false where not all triangles could be ears: the outline crosses itself, and some triangles
///            overlap or lie outside of it
///
/// source     Meisters 1975, "Polygons Have Ears"; Newell's normal is that of Sutherland, Sproull and
///            Schumacker 1974, "A Characterization of Ten Hidden-Surface Algorithms"
bool triangulate_polygon(std::span<const glm::vec3> corner, std::vector<glm::uvec3>& triangles);

} // namespace firsthit
