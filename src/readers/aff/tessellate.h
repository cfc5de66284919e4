// tessellate.h - spheres and cones as triangles.
//
//     sphere: rings of `segments` vertices, poles on the y axis       cone: two rings, open at both
//     ends
//            ____                                                          ______  apex
//          /_/|_\_\                                                       /__|___\ base
//         |__|__|__|
//          \_\|_/_/
#pragma once

#include <glm/vec3.hpp>

#include <vector>

namespace firsthit::aff {

/// Triangles with smooth unit normals, counter-clockwise = the side that the normals point to.
struct Facets {
    std::vector<glm::vec3> position;
    std::vector<glm::vec3> normal;
    std::vector<glm::uvec3> triangle;
};

/// The vertices lie on the sphere. A negative radius gives its inside.
/// segments  3 or more around the equator, half of it from pole to pole but 2 at least:
///           segments * (segments - 2) triangles where it is even, 6 for 3 segments
Facets tessellate_sphere(const glm::dvec3& center, double radius, int segments);

/// A cone or cylinder without its ends: 2 * segments triangles, or half of it where a radius is 0,
/// or none where both are. Base and apex differ; both radii negative give the inside.
struct Cone {
    glm::dvec3 base{0};
    double base_radius = 1;
    glm::dvec3 apex{0, 1, 0};
    double apex_radius = 0;
};
/// segments  3 or more
Facets tessellate_cone(const Cone& cone, int segments);

} // namespace firsthit::aff
