// ply_faces.cpp - makes triangles of the faces and strips of a PLY file.
#include "readers/mesh/ply/ply_faces.h"
#include "readers/mesh/triangulate_polygon.h"
#include "base/reserve_large.h"

#include <fmt/format.h>

namespace firsthit {
namespace {

template <class T>
void append(std::vector<T>& to, std::vector<T>& from)
{
    if (to.empty())
        to = std::move(from);
    else
        to.insert(to.end(), from.begin(), from.end());
    from = {};
}

} // namespace

void PlyTriangleMaker::add_any(const PlyFace& face, std::size_t number)
{
    const auto count = static_cast<std::uint32_t>(face.corner.size());
    if (count < 3) {
        if (triangles.thin++ == 0) triangles.first_thin = number;
        return;
    }
    cut_.clear();
    if (count == 3) {
        cut_.emplace_back(0, 1, 2);
    } else {
        outline_.clear();
        for (const std::uint32_t vertex : face.corner) outline_.push_back(position_[vertex]);
        if (!triangulate_polygon(outline_, cut_) && triangles.crossed++ == 0)
            triangles.first_crossed = number;
    }
    for (const glm::uvec3& three : cut_)
        triangles.index.emplace_back(
            face.corner[three.x], face.corner[three.y], face.corner[three.z]);
    if (colored_) triangles.color.insert(triangles.color.end(), cut_.size(), face.color);
    if (!has_uv_) return;

    const auto first = static_cast<std::uint32_t>(triangles.uv.size());
    const bool fits = face.texcoord.size() == 2 * face.corner.size();
    if (!fits && triangles.without_uv++ == 0) triangles.first_without_uv = number;
    for (std::size_t k = 0; k < count; ++k)
        triangles.uv.push_back(
            fits ? glm::vec2(face.texcoord[2 * k], face.texcoord[2 * k + 1]) : glm::vec2(0));
    for (const glm::uvec3& three : cut_) triangles.uv_index.push_back(three + first);
}

void PlyTriangleMaker::add_strip(std::span<const std::int64_t> vertices)
{
    std::size_t length = 0; // of the strip so far
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        length = vertices[k] < 0 ? 0 : length + 1;
        if (length < 3) continue;
        const auto a = static_cast<std::uint32_t>(vertices[k - 2]);
        const auto b = static_cast<std::uint32_t>(vertices[k - 1]);
        const auto c = static_cast<std::uint32_t>(vertices[k]);
        if (length % 2 == 1)
            triangles.index.emplace_back(a, b, c);
        else
            triangles.index.emplace_back(b, a, c);
    }
}

void append_triangles(std::vector<PlyTriangles>& parts, RawMesh& mesh)
{
    std::size_t triangles = mesh.index.size();
    for (const PlyTriangles& part : parts) triangles += part.index.size();
    reserve_in_large_pages(mesh.index, triangles);
    for (PlyTriangles& part : parts) {
        // Where some triangles have a colour or texture coordinates, all have.
        const std::size_t before = mesh.index.size();
        if (!part.color.empty()) {
            mesh.triangle_color.resize(before, glm::vec4(1));
            append(mesh.triangle_color, part.color);
        }
        if (!part.uv_index.empty()) {
            if (before > 0 && mesh.uv.empty()) mesh.uv.emplace_back(0.0f, 0.0f);
            mesh.uv_index.resize(before, glm::uvec3(0));
            const auto first = static_cast<std::uint32_t>(mesh.uv.size());
            for (const glm::uvec3& corners : part.uv_index)
                mesh.uv_index.push_back(corners + first);
            append(mesh.uv, part.uv);
        }
        mesh.index.insert(mesh.index.end(), part.index.begin(), part.index.end());
        if (!mesh.triangle_color.empty())
            mesh.triangle_color.resize(mesh.index.size(), glm::vec4(1));
        if (!mesh.uv_index.empty()) mesh.uv_index.resize(mesh.index.size(), glm::uvec3(0));
        part.index = {};
        mesh.problems.add_times(kThinFaces, part.thin, "face", part.first_thin);
        mesh.problems.add_times("faces whose outline crosses itself are cut as well as may be",
            part.crossed, "face", part.first_crossed);
        mesh.problems.add_times("texture coordinates that are not two a corner are taken as 0",
            part.without_uv, "face", part.first_without_uv);
    }
}

} // namespace firsthit
