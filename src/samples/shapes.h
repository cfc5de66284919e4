// shapes.h - rounded solids, made of triangles with smooth normals.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace firsthit {

/// Triangles that grow shape by shape. No shape makes a triangle without area.
struct Shape {
    std::vector<glm::vec3> position;
    std::vector<glm::vec3> normal; // unit
    std::vector<glm::uvec3> index; // counter-clockwise = outside
};

/// A point of the outline of a solid of revolution. Two points in the same place make a crease.
struct Outline {
    double radius = 0;
    double y = 0;
};

/// Adds a solid of revolution around y.
///
/// outline            from the top to the bottom; a radius of 0 closes it there
/// segments           around the axis, 3 or more
/// shape_from_solid   rigid, possibly scaled alike on all axes
void add_lathe(Shape& shape, std::span<const Outline> outline, int segments,
    const glm::dmat4& shape_from_solid = glm::dmat4(1));

/// Adds an ellipsoid around the origin.
///
/// radius    on each axis
/// segments  around y; half as many from pole to pole
void add_ellipsoid(Shape& shape, const glm::dvec3& radius, int segments,
    const glm::dmat4& shape_from_solid = glm::dmat4(1));

/// Adds a box around the origin with rounded edges.
///
/// half      sides, halved
/// rounding  radius of the edges, at most the smallest half side
/// segments  over a quarter of a rounding, 1 or more
/// taper     the bottom's width as a part of the top's, in x and z
void add_rounded_box(Shape& shape, const glm::dvec3& half, double rounding, int segments,
    const glm::dmat4& shape_from_solid = glm::dmat4(1), double taper = 1.0);

/// Adds a triangle of vertices that are there, unless it has no area (at poles and creases).
void add_triangle(Shape& shape, std::uint32_t a, std::uint32_t b, std::uint32_t c);

/// Moves, for the arguments above.
glm::dmat4 moved(double x, double y, double z);
/// Moves, and turns around an axis before.
glm::dmat4 moved(double x, double y, double z, const glm::dvec3& axis, double angle_rad);

} // namespace firsthit
