// mesh_vertices.cpp - makes vertices from the corners of a mesh file.
#include "readers/mesh/mesh_vertices.h"
#include "scene/model/smooth_normals.h"
#include "readers/mesh/weld.h"
#include "base/large_pages.h"
#include "base/reserve_large.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace firsthit {
namespace {

constexpr std::size_t kGrain = 1 << 14; // triangles that one thread takes at once

/// Everything that can differ between corners.
struct Values {
    std::vector<glm::vec3> position;
    std::vector<glm::vec3> normal;
    std::vector<glm::vec2> uv;
    std::vector<glm::vec4> color;
};

/// The vertex of each corner of all triangles. Equal numbers are equal vertices.
struct CornerVertices {
    std::vector<std::uint32_t> number; // (3 T)
    std::size_t count = 0;             // numbers are less
    std::vector<VertexKey> key;        // (3 T) what corners have; or empty
    std::vector<glm::uvec3> point;     // (T) where key is empty: corners have this position,
                                       // and the normal of their vertex's number

    VertexKey key_of(std::size_t corner) const
    {
        if (!key.empty()) return key[corner];
        return {point[corner / 3][static_cast<int>(corner % 3)], number[corner], 0, 0};
    }
};

/// The point of each corner.
std::vector<glm::uvec3> points_of_corners(
    const std::vector<glm::uvec3>& index, const std::vector<std::uint32_t>& number, Tasks& tasks)
{
    std::vector<glm::uvec3> points;
    resize_in_large_pages(points, index.size());
    tasks.for_ranges(index.size(), kGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t t = first; t < last; ++t)
            for (int k = 0; k < 3; ++k) points[t][k] = number[index[t][k]];
    });
    return points;
}

/// Numbers a corner's normal: the file's where it has one, else the smooth one.
/// returns  (3 T)
std::vector<std::uint32_t> corner_normals(
    const RawMesh& raw, SmoothNormals smooth, std::vector<glm::vec3>& normal, Tasks& tasks)
{
    normal = std::move(smooth.normal);
    if (raw.normal.empty()) return std::move(smooth.corner);

    const Welded given = weld(std::span(raw.normal), tasks);
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

/// Numbers texture coordinates without repetition.
std::vector<std::uint32_t> number_uvs(const RawMesh& raw, std::vector<glm::vec2>& uv, Tasks& tasks)
{
    std::vector<glm::vec3> flat;
    flat.reserve(raw.uv.size());
    for (const glm::vec2& value : raw.uv) flat.emplace_back(value, 0.0f);
    Welded welded = weld(std::span<const glm::vec3>(flat), tasks);
    for (const std::uint32_t first : welded.first) uv.push_back(raw.uv[first]);
    return std::move(welded.number);
}

/// Numbers each corner's colour, that of its vertex times that of its triangle.
/// returns  (3 T)
std::vector<std::uint32_t> corner_colors(
    const RawMesh& raw, std::vector<glm::vec4>& color, Tasks& tasks)
{
    std::vector<VertexKey> bits;
    bits.reserve(raw.index.size() * 3);
    std::vector<glm::vec4> colors;
    colors.reserve(bits.capacity());
    for (std::size_t t = 0; t < raw.index.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            glm::vec4 value(1);
            if (!raw.color.empty()) value = raw.color[raw.index[t][k]];
            if (!raw.triangle_color.empty()) value *= raw.triangle_color[t];
            colors.push_back(value);
            bits.push_back(key_bits(value));
        }
    Welded welded = weld(std::span<const VertexKey>(bits), tasks);
    for (const std::uint32_t first : welded.first) color.push_back(colors[first]);
    return std::move(welded.number);
}

/// Numbers the vertices of a mesh that has more than positions.
CornerVertices weld_corners(const RawMesh& raw, const std::vector<glm::uvec3>& point,
    SmoothNormals smooth, Values& values, Tasks& tasks)
{
    const std::vector<std::uint32_t> normal =
        corner_normals(raw, std::move(smooth), values.normal, tasks);
    std::vector<std::uint32_t> uv, color;
    if (!raw.uv.empty()) uv = number_uvs(raw, values.uv, tasks);
    if (!raw.color.empty() || !raw.triangle_color.empty())
        color = corner_colors(raw, values.color, tasks);

    CornerVertices vertices;
    const std::vector<glm::uvec3>& uv_index = raw.uv_index.empty() ? raw.index : raw.uv_index;
    vertices.key.reserve(3 * point.size());
    for (std::size_t c = 0; c < 3 * point.size(); ++c) {
        const int k = static_cast<int>(c % 3);
        vertices.key.push_back({point[c / 3][k], normal[c],
            uv.empty() ? 0u : uv[uv_index[c / 3][k]], color.empty() ? 0u : color[c]});
    }
    Welded welded = weld(std::span<const VertexKey>(vertices.key), tasks);
    vertices.number = std::move(welded.number);
    vertices.count = welded.first.size();
    return vertices;
}

/// Makes the meshes of runs of triangles, one after the other.
class MeshMaker {
  public:
    MeshMaker(const CornerVertices& vertices, const Values& values)
        : vertices_(vertices),
          values_(values),
          used_(vertices.count, kUnused),
          number_(vertices.count)
    {
    }

    /// Vertices are numbered in order of first use, so that what is near in the index is near in memory.
    Mesh make(std::size_t first, std::size_t last, std::uint32_t run)
    {
        Mesh mesh;
        resize_in_large_pages(mesh.index, last - first);
        if (first == 0 && 3 * last == vertices_.number.size()) {
            reserve_in_large_pages(mesh.position, vertices_.count);
            reserve_in_large_pages(mesh.normal, vertices_.count);
        }
        for (std::size_t t = first; t < last; ++t)
            for (int k = 0; k < 3; ++k) {
                const std::size_t corner = 3 * t + static_cast<std::size_t>(k);
                const std::uint32_t vertex = vertices_.number[corner];
                if (used_[vertex] != run) {
                    used_[vertex] = run;
                    number_[vertex] = static_cast<std::uint32_t>(mesh.position.size());
                    append(vertices_.key_of(corner), mesh);
                }
                mesh.index[t - first][k] = number_[vertex];
            }
        return mesh;
    }

  private:
    static constexpr std::uint32_t kUnused = 0xFFFFFFFFu;

    void append(const VertexKey& key, Mesh& mesh) const
    {
        mesh.position.push_back(values_.position[key[0]]);
        mesh.normal.push_back(values_.normal[key[1]]);
        if (!values_.uv.empty()) mesh.uv.push_back(values_.uv[key[2]]);
        if (!values_.color.empty()) mesh.color.push_back(values_.color[key[3]]);
    }

    const CornerVertices& vertices_;
    const Values& values_;
    std::vector<std::uint32_t> used_;   // (vertices) by the last run that does
    std::vector<std::uint32_t> number_; // (vertices) in that run's mesh
};

} // namespace

std::vector<Mesh> make_meshes(
    RawMesh raw, std::span<const std::size_t> first_triangle, double crease_angle_rad, Tasks& tasks)
{
    // Weld equal positions: normals are smooth across them whatever else differs.
    Values values;
    std::vector<glm::uvec3> point;
    {
        const Welded points = weld(std::span(raw.position), tasks);
        reserve_in_large_pages(values.position, points.first.size());
        for (const std::uint32_t first : points.first)
            values.position.push_back(raw.position[first]);
        point = points_of_corners(raw.index, points.number, tasks);
    }
    const bool plain =
        raw.normal.empty() && raw.uv.empty() && raw.color.empty() && raw.triangle_color.empty();
    raw.position = {};
    const std::vector<std::uint32_t> smoothing = std::move(raw.smoothing);
    if (plain) raw = {};

    // Where there are only positions, a vertex is a normal, which belongs to one point.
    SmoothNormals smooth =
        smooth_normals(values.position, point, crease_angle_rad, tasks, smoothing);
    CornerVertices vertices;
    if (plain) {
        values.normal = std::move(smooth.normal);
        vertices.number = std::move(smooth.corner);
        vertices.count = values.normal.size();
        vertices.point = std::move(point);
    } else {
        vertices = weld_corners(raw, point, std::move(smooth), values, tasks);
        point = {};
        raw = {};
    }

    std::vector<Mesh> meshes;
    MeshMaker maker(vertices, values);
    for (std::size_t r = 0; r < first_triangle.size(); ++r) {
        const std::size_t end =
            r + 1 < first_triangle.size() ? first_triangle[r + 1] : vertices.number.size() / 3;
        meshes.push_back(maker.make(first_triangle[r], end, static_cast<std::uint32_t>(r)));
    }
    return meshes;
}

} // namespace firsthit
