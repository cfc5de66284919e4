// swept.h - tubes along paths, sheets over grids and sharp boxes: what furniture has besides lathed parts.
#pragma once

#include "samples/shapes.h"

#include <functional>
#include <span>
#include <vector>

namespace firsthit {

/// A point of a tube's middle line.
struct TubePoint {
    glm::dvec3 place{0};
    double radius = 0;
};

/// How a tube is made.
struct TubeStyle {
    int sides = 8;              // of its cross section, 3 or more
    glm::dvec3 across{0, 1, 0}; // nowhere parallel to the path; the cross sections are turned to it
    bool ring = false;          // the last point is joined to the first, else both ends get a cap
};

/// Adds a closed tube. Neighbouring points have to be in different places.
/// path  two points or more, of a ring three or more
void add_tube(Shape& shape, std::span<const TubePoint> path, const TubeStyle& style = {},
    const glm::dmat4& shape_from_solid = glm::dmat4(1));

/// Adds a straight tube of one radius.
void add_rod(Shape& shape, const glm::dvec3& from, const glm::dvec3& to, double radius, int sides);

/// Points on a part of a circle, for add_tube.
/// place  where the path is for u from 0 to 1
std::vector<TubePoint> sample_path(
    int steps, double radius, const std::function<glm::dvec3(double u)>& place);

/// Adds a surface over a grid of columns x rows quads, seen from both sides, open at its edges.
///
/// place    where it is for u and v from 0 to 1
/// returns  u and v of the vertices that were added
std::vector<glm::vec2> add_sheet(Shape& shape, int columns, int rows,
    const std::function<glm::dvec3(double u, double v)>& place);

/// Adds a box around the origin with sharp edges.
void add_box(
    Shape& shape, const glm::dvec3& half, const glm::dmat4& shape_from_solid = glm::dmat4(1));

/// Texture coordinates of a shape as if it were wrapped in a box: those of the axes that the normal does not
/// point along. On faces that look along y, u goes along z where `turned`, else along x.
/// size  of the texture, metres
std::vector<glm::vec2> box_mapping(const Shape& shape, double size, bool turned = false);

} // namespace firsthit
