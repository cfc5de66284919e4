// platonic.cpp - tetrahedra, cubes, octahedra and dodecahedra of extended NFF.
//
// Each is given by its corners and the directions of its faces: a face has the corners that lie farthest in
// its direction.
#include "readers/aff/facets.h"
#include "readers/aff/statements.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace firsthit::aff {
namespace {

using Points = std::vector<glm::dvec3>;

/// The points (+-x, +-y, +-z), without repetition where some are 0.
Points with_all_signs(const glm::dvec3& p)
{
    Points points;
    for (int signs = 0; signs < 8; ++signs) {
        const glm::dvec3 q(signs & 1 ? -p.x : p.x, signs & 2 ? -p.y : p.y, signs & 4 ? -p.z : p.z);
        if (std::find(points.begin(), points.end(), q) == points.end()) points.push_back(q);
    }
    return points;
}

/// The same for (x, y, z), (y, z, x) and (z, x, y).
Points in_turn(const glm::dvec3& p)
{
    Points points;
    for (const glm::dvec3& turned : {p, glm::dvec3(p.y, p.z, p.x), glm::dvec3(p.z, p.x, p.y)})
        for (const glm::dvec3& q : with_all_signs(turned)) points.push_back(q);
    return points;
}

Points joined(Points a, const Points& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

struct Solid {
    Points corner;
    Points face; // directions
};

const double kGolden = (1 + std::sqrt(5.0)) / 2;

Solid tetrahedron()
{
    return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
        {{-1, -1, -1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, -1}}};
}

Solid cube()
{
    return {with_all_signs({1, 1, 1}), in_turn({1, 0, 0})};
}

Solid octahedron()
{
    return {in_turn({1, 0, 0}), with_all_signs({1, 1, 1})};
}

Solid dodecahedron()
{
    return {joined(with_all_signs({1, 1, 1}), in_turn({0, 1 / kGolden, kGolden})),
        in_turn({0, kGolden, 1})};
}

/// The corners of the face in a direction, counter-clockwise seen from outside.
Points face_of(const Solid& solid, const glm::dvec3& direction)
{
    double farthest = 0;
    for (const glm::dvec3& p : solid.corner) farthest = std::max(farthest, glm::dot(p, direction));
    Points face;
    glm::dvec3 middle(0);
    for (const glm::dvec3& p : solid.corner)
        if (glm::dot(p, direction) > farthest - 1e-6) {
            face.push_back(p);
            middle += p;
        }
    middle /= double(face.size());
    const glm::dvec3 right = face[0] - middle;
    const glm::dvec3 up = glm::cross(glm::normalize(direction), right);
    const auto angle = [&](const glm::dvec3& p) {
        return std::atan2(glm::dot(p - middle, up), glm::dot(p - middle, right));
    };
    std::sort(face.begin(), face.end(),
        [&](const glm::dvec3& a, const glm::dvec3& b) { return angle(a) < angle(b); });
    return face;
}

/// x y z r: around a point, with corners at that distance.
void read_solid(Lexer& lexer, State& state, const Solid& solid)
{
    const glm::dvec3 center = lexer.small_triple("the solid's middle");
    const glm::dvec3 radius = lexer.radii("the solid's radius");
    const bool is_flat = radius.x * radius.y * radius.z == 0; // and has any normals
    state.builder.begin_instance(
        lexer, state.node, state.builder.material(state.material_name, state.material, -1));
    for (const glm::dvec3& direction : solid.face) {
        const glm::vec3 normal(glm::normalize(is_flat ? direction : direction / radius));
        const std::uint32_t first = state.builder.vertices();
        const Points face = face_of(solid, direction);
        for (const glm::dvec3& p : face) {
            const glm::vec3 corner(center + glm::normalize(p) * radius);
            for (int axis = 0; axis < 3; ++axis)
                if (!std::isfinite(corner[axis]))
                    lexer.fail_scene("the shape reaches beyond +-3.4e38");
            state.builder.add_vertex(corner, normal);
        }
        for (std::uint32_t k = 2; k < face.size(); ++k)
            state.builder.add_triangle(first, first + k - 1, first + k);
    }
}

} // namespace

void read_tetrahedron(Lexer& lexer, State& state)
{
    read_solid(lexer, state, tetrahedron());
}
void read_cube(Lexer& lexer, State& state)
{
    read_solid(lexer, state, cube());
}
void read_octahedron(Lexer& lexer, State& state)
{
    read_solid(lexer, state, octahedron());
}
void read_dodecahedron(Lexer& lexer, State& state)
{
    read_solid(lexer, state, dodecahedron());
}

} // namespace firsthit::aff
