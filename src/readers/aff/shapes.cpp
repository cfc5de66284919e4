// shapes.cpp - spheres, cones, polygons and single triangles of an AFF scene.
#include "readers/aff/facets.h"
#include "readers/aff/statements.h"
#include "readers/aff/tessellate.h"
#include "readers/mesh/triangulate_polygon.h"
#include "io/parse_number.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace firsthit::aff {
namespace {

bool is_finite_point(const glm::vec3& p)
{
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Reads a corner's normal if there is one; zero, which means that it is computed, otherwise.
glm::vec3 corner_normal(Lexer& lexer, bool has_normal)
{
    if (!has_normal) return glm::vec3(0);
    const glm::vec3 normal = lexer.any_triple("a corner's normal");
    return is_finite_point(normal) ? normal : glm::vec3(0);
}

void begin_plain_instance(const Lexer& lexer, State& state)
{
    state.builder.begin_instance(
        lexer, state.node, state.builder.material(state.material_name, state.material, -1));
}

void add_facets(const Lexer& lexer, State& state, const Facets& facets)
{
    for (const glm::vec3& p : facets.position)
        for (int axis = 0; axis < 3; ++axis)
            if (!std::isfinite(p[axis])) lexer.fail_scene("the shape reaches beyond +-3.4e38");
    begin_plain_instance(lexer, state);
    const std::uint32_t first = state.builder.vertices();
    for (std::size_t v = 0; v < facets.position.size(); ++v)
        state.builder.add_vertex(facets.position[v], facets.normal[v]);
    for (const glm::uvec3& t : facets.triangle)
        state.builder.add_triangle(first + t.x, first + t.y, first + t.z);
}

struct PolygonCorners {
    std::vector<glm::vec3> position;
    std::vector<glm::vec3> normal; // zero where there is none
};

PolygonCorners read_corners(Lexer& lexer, std::uint32_t count, bool have_normals)
{
    // As many as the file can still hold: a corner is 6 bytes or more.
    PolygonCorners corners;
    corners.position.reserve(std::min<std::size_t>(count, lexer.remaining() / 6 + 1));
    for (std::uint32_t k = 0; k < count; ++k) {
        corners.position.push_back(lexer.any_triple("a corner"));
        corners.normal.push_back(corner_normal(lexer, have_normals));
    }
    return corners;
}

/// Some programs write a colour or texture coordinates behind every corner, which nothing announces but
/// the end of the line. Reads such corners, each a line with one number more or several.
/// returns  nothing where the lines are others
std::optional<PolygonCorners> read_corner_lines(
    Lexer& lexer, std::uint32_t count, bool have_normals)
{
    PolygonCorners corners;
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::size_t line_before = lexer.line();
        if (!parse_number(lexer.peek())) return {};
        corners.position.push_back(lexer.any_triple("a corner"));
        const std::size_t line = lexer.line();
        if (line == line_before || !lexer.has_more_on_line()) return {};
        corners.normal.push_back(corner_normal(lexer, have_normals));
        while (lexer.has_more_on_line())
            if (!parse_number(lexer.next())) return {};
        if (lexer.line() != line) return {};
    }
    if (parse_number(lexer.peek())) return {};
    return corners;
}

void read_any_polygon(Lexer& lexer, State& state, bool has_normals)
{
    const std::uint32_t count = lexer.count("the number of corners");
    const Lexer::Mark begin = lexer.mark();
    PolygonCorners corners = read_corners(lexer, count, has_normals);
    if (parse_number(lexer.peek())) {
        const Lexer::Mark end = lexer.mark();
        lexer.go_back(begin);
        if (auto lines = read_corner_lines(lexer, count, has_normals)) {
            corners = std::move(*lines);
            state.builder.problems.add(
                "spare numbers of corners are left out", "line", lexer.line());
        } else {
            lexer.go_back(end);
        }
    }
    const std::vector<glm::vec3>& position = corners.position;
    const std::vector<glm::vec3>& normal = corners.normal;
    if (count < 3) {
        state.builder.problems.add(
            "polygons with fewer than 3 corners are left out", "line", lexer.line());
        return;
    }
    if (!std::all_of(position.begin(), position.end(), is_finite_point)) {
        state.builder.problems.add(
            "polygons with a corner that is no finite float are left out", "line", lexer.line());
        return;
    }

    begin_plain_instance(lexer, state);
    const glm::vec3 flat = flat_normal(position);
    const std::uint32_t first = state.builder.vertices();
    for (std::size_t k = 0; k < count; ++k)
        state.builder.add_vertex(position[k], unit_or(normal[k], flat));
    if (count == 3) {
        state.builder.add_triangle(first, first + 1, first + 2);
        return;
    }
    std::vector<glm::uvec3> triangles;
    if (!triangulate_polygon(position, triangles))
        state.builder.problems.add(
            "polygons whose outline crosses itself are cut as well as may be", "line",
            lexer.line());
    for (const glm::uvec3& t : triangles)
        state.builder.add_triangle(first + t.x, first + t.y, first + t.z);
}

void read_any_textured_triangle(Lexer& lexer, State& state, bool has_normals)
{
    const std::string_view name = lexer.word("the texture's name");
    const std::int32_t texture = state.builder.texture(lexer, name);
    std::array<glm::vec3, 3> position;
    std::array<glm::vec3, 3> normal;
    std::array<glm::vec2, 3> uv;
    for (std::size_t k = 0; k < 3; ++k) {
        position[k] = lexer.small_triple("a corner");
        normal[k] = corner_normal(lexer, has_normals);
        uv[k] = lexer.small_pair("a texture coordinate");
    }

    state.builder.begin_instance(
        lexer, state.node, state.builder.material(state.material_name, state.material, texture));
    const glm::vec3 flat = flat_normal(position);
    std::array<std::uint32_t, 3> vertex;
    for (std::size_t k = 0; k < 3; ++k)
        vertex[k] = state.builder.add_vertex(position[k], unit_or(normal[k], flat), uv[k]);
    state.builder.add_triangle(vertex[0], vertex[1], vertex[2]);
}

} // namespace

void read_sphere(Lexer& lexer, State& state)
{
    const glm::dvec3 center = lexer.small_triple("the sphere's middle");
    const glm::dvec3 radius = lexer.radii("the sphere's radius");
    const int segments = state.settings.sphere_segments;
    if (radius == glm::dvec3(radius.x)) {
        add_facets(lexer, state, tessellate_sphere(center, radius.x, segments));
        return;
    }
    Facets facets = tessellate_sphere(glm::dvec3(0), 1, segments);
    const bool is_flat = radius.x * radius.y * radius.z == 0; // and has any normals
    for (glm::vec3& p : facets.position) p = glm::vec3(center + radius * glm::dvec3(p));
    if (!is_flat)
        for (glm::vec3& n : facets.normal) n = glm::vec3(glm::normalize(glm::dvec3(n) / radius));
    add_facets(lexer, state, facets);
}

void read_cone(Lexer& lexer, State& state)
{
    Cone cone;
    cone.base = lexer.small_triple("the cone's base");
    cone.base_radius = lexer.small_number("the cone's radius at the base");
    cone.apex = lexer.small_triple("the cone's apex");
    cone.apex_radius = lexer.small_number("the cone's radius at the apex");
    if (cone.base == cone.apex) lexer.fail_scene("the cone's base and apex are the same point");
    if (cone.base_radius * cone.apex_radius < 0)
        lexer.fail_scene("the cone's radii should both be positive or both negative");
    if (cone.base_radius == 0 && cone.apex_radius == 0) {
        state.builder.warn(lexer, "a cone without radii is left out");
        return;
    }
    add_facets(lexer, state, tessellate_cone(cone, state.settings.cone_segments));
}

void read_polygon(Lexer& lexer, State& state)
{
    read_any_polygon(lexer, state, false);
}
void read_smooth_polygon(Lexer& lexer, State& state)
{
    read_any_polygon(lexer, state, true);
}

void read_textured_triangle(Lexer& lexer, State& state)
{
    read_any_textured_triangle(lexer, state, false);
}

void read_textured_smooth_triangle(Lexer& lexer, State& state)
{
    read_any_textured_triangle(lexer, state, true);
}

void read_animated_triangle(Lexer& lexer, State& state)
{
    const std::uint32_t count = lexer.count("the number of keys");
    if (count < 1) lexer.fail_scene("an animated triangle should have 1 key or more");
    std::vector<MorphKey> keys;
    for (std::uint32_t k = 0; k < count; ++k) {
        MorphKey key;
        key.time_s = lexer.small_number("a key's time");
        if (k > 0 && key.time_s < keys.back().time_s)
            lexer.fail_scene("the keys of an animated triangle should be in order of time");
        for (int corner = 0; corner < 3; ++corner) {
            key.position.push_back(lexer.small_triple("a corner"));
            key.normal.push_back(lexer.small_triple("a corner's normal"));
        }
        const glm::vec3 flat = flat_normal(key.position);
        for (glm::vec3& normal : key.normal) normal = unit_or(normal, flat);
        keys.push_back(std::move(key));
    }
    state.builder.add_morph_triangle(
        lexer, state.node, state.builder.material(state.material_name, state.material, -1), keys);
}

} // namespace firsthit::aff
