// mesh_vertices.cpp - makes the vertices of a scene from the corners of a mesh file.
#include "readers/mesh/mesh_vertices.h"
#include "scene/model/smooth_normals.h"
#include "readers/mesh/weld.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace firsthit {
namespace {

/// Everything that can differ between corners, each without repetition.
struct Values {
    std::vector<glm::vec3> position;
    std::vector<glm::vec3> normal;
    std::vector<glm::vec2> uv;
};

/// New numbers of the points in order of first use, so that what is near in the index is near in
/// memory; fewer than there are points where some are unused, whose number stays kUnused.
struct UseOrder {
    static constexpr std::uint32_t kUnused = 0xFFFFFFFFu;

    std::vector<std::uint32_t> number; // of each point
    std::uint32_t used = 0;

    UseOrder(std::span<const glm::uvec3> index, std::size_t points) : number(points, kUnused)
    {
        for (const glm::uvec3& corners : index)
            for (int k = 0; k < 3; ++k)
                if (std::uint32_t& n = number[corners[k]]; n == kUnused) n = used++;
    }

    bool uses_all() const { return used == number.size(); }

    template <class T>
    std::vector<T> ordered(const std::vector<T>& values) const
    {
        std::vector<T> moved(values.size());
        for (std::size_t k = 0; k < values.size(); ++k) moved[number[k]] = values[k];
        return moved;
    }
};

/// Numbers a corner's normal: the file's where it has one, else the smooth one.
/// returns  (3 T)
std::vector<std::uint32_t> corner_normals(
    const RawMesh& raw, SmoothNormals smooth, std::vector<glm::vec3>& normal)
{
    normal = std::move(smooth.normal);
    if (raw.normal.empty()) return std::move(smooth.corner);

    const Welded given = weld(std::span(raw.normal));
    const auto base = static_cast<std::uint32_t>(normal.size());
    for (const std::uint32_t first : given.first) {
        const glm::dvec3 n(raw.normal[first]);
        const double length = glm::length(n);
        normal.push_back(length > 0 ? glm::vec3(n / length) : glm::vec3(0));
    }
    const std::vector<glm::uvec3>& index = raw.normal_index.empty() ? raw.index : raw.normal_index;
    std::vector<std::uint32_t> corner = std::move(smooth.corner);
    for (std::size_t c = 0; c < corner.size(); ++c) {
        const std::uint32_t vertex = index[c / 3][static_cast<int>(c % 3)];
        const std::uint32_t number = base + given.number[vertex];
        if (normal[number] != glm::vec3(0)) corner[c] = number;
    }
    return corner;
}

/// keys  (3 T) what each corner has: numbers of position, normal, uv
void make_part_vertices(
    Part& part, std::span<const glm::uvec3> keys, const Values& values, Scene& scene)
{
    const std::size_t first_corner = std::size_t(part.first_triangle) * 3;
    const std::size_t corners = std::size_t(part.triangle_count) * 3;
    const Welded vertices = weld(keys.subspan(first_corner, corners));
    part.first_vertex = static_cast<std::uint32_t>(scene.position.size());
    part.vertex_count = static_cast<std::uint32_t>(vertices.first.size());
    for (const std::uint32_t first : vertices.first) {
        const glm::uvec3& key = keys[first_corner + first];
        scene.position.push_back(values.position[key.x]);
        scene.normal.push_back(values.normal[key.y]);
        if (!values.uv.empty()) scene.uv.push_back(values.uv[key.z]);
    }
    for (std::size_t c = 0; c < corners; c += 3)
        scene.index.emplace_back(part.first_vertex + vertices.number[c],
            part.first_vertex + vertices.number[c + 1], part.first_vertex + vertices.number[c + 2]);
}

} // namespace

void make_vertices(RawMesh raw, double crease_angle_rad, Scene& scene)
{
    // Weld equal positions: normals are smooth across them whatever else differs.
    Values values;
    std::vector<glm::uvec3> by_point = raw.index;
    Welded points = weld(std::span(raw.position));
    values.position.reserve(points.first.size());
    for (const std::uint32_t first : points.first) values.position.push_back(raw.position[first]);
    for (glm::uvec3& corners : by_point)
        for (int k = 0; k < 3; ++k) corners[k] = points.number[corners[k]];
    raw.position = {};
    points = {};

    SmoothNormals smooth = smooth_normals(values.position, by_point, crease_angle_rad);

    // Where a vertex is a point, that is all.
    if (smooth.one_a_point && raw.normal.empty() && raw.uv.empty() && scene.parts.size() == 1) {
        const UseOrder order(by_point, values.position.size());
        if (order.uses_all()) {
            scene.position = order.ordered(values.position);
            scene.normal = order.ordered(smooth.normal);
            for (glm::uvec3& corners : by_point)
                for (int k = 0; k < 3; ++k) corners[k] = order.number[corners[k]];
            scene.index = std::move(by_point);
            scene.vertices = scene.position.size();
            scene.parts[0].vertex_count = static_cast<std::uint32_t>(scene.vertices);
            return;
        }
    }

    // Otherwise vertices are what differs in position, normal or texture coordinates.
    const std::vector<std::uint32_t> normal = corner_normals(raw, std::move(smooth), values.normal);
    Welded uvs;
    if (!raw.uv.empty()) {
        std::vector<glm::vec3> flat;
        flat.reserve(raw.uv.size());
        for (const glm::vec2& uv : raw.uv) flat.emplace_back(uv, 0.0f);
        uvs = weld(std::span<const glm::vec3>(flat));
        for (const std::uint32_t first : uvs.first) values.uv.push_back(raw.uv[first]);
    }
    const std::vector<glm::uvec3>& uv_index = raw.uv_index.empty() ? raw.index : raw.uv_index;
    std::vector<glm::uvec3> keys;
    keys.reserve(by_point.size() * 3);
    for (std::size_t t = 0; t < by_point.size(); ++t)
        for (int k = 0; k < 3; ++k)
            keys.emplace_back(by_point[t][k], normal[3 * t + static_cast<std::size_t>(k)],
                raw.uv.empty() ? 0u : uvs.number[uv_index[t][k]]);
    by_point = {};
    raw = {};

    scene.index.reserve(keys.size() / 3);
    for (Part& part : scene.parts) make_part_vertices(part, keys, values, scene);
    scene.vertices = scene.position.size();
}

} // namespace firsthit
