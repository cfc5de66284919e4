// raw_mesh.cpp - what the readers of all mesh formats share.
#include "readers/mesh/raw_mesh.h"

#include <firsthit/error.h>

#include <fmt/format.h>

#include <cmath>

namespace firsthit {
namespace {

template <class Vector>
bool is_finite(const Vector& v)
{
    // Not zero where one of them is not finite.
    float sum = 0;
    for (int k = 0; k < Vector::length(); ++k) sum += v[k] * 0.0f;
    return sum == 0.0f;
}

/// Replaces what is not finite.
/// index    of the corners into the values
/// returns  how many of those that a triangle uses there were
template <class Vector>
std::size_t replace(
    std::vector<Vector>& values, const std::vector<glm::uvec3>& index, const Vector& by)
{
    std::vector<bool> bad;
    for (std::size_t k = 0; k < values.size(); ++k)
        if (!is_finite(values[k])) {
            values[k] = by;
            bad.resize(values.size());
            bad[k] = true;
        }
    if (bad.empty()) return 0;
    std::size_t used = 0;
    for (const glm::uvec3& corners : index)
        for (int k = 0; k < 3; ++k)
            if (bad[corners[k]]) {
                bad[corners[k]] = false;
                ++used;
            }
    return used;
}

/// Keeps the values of triangles that stay.
template <class T>
void keep(std::vector<T>& values, const std::vector<bool>& stays)
{
    if (values.empty()) return;
    std::size_t kept = 0;
    for (std::size_t t = 0; t < values.size(); ++t)
        if (stays[t]) values[kept++] = values[t];
    values.resize(kept);
}

void leave_out_triangles(RawMesh& mesh, const std::vector<bool>& stays)
{
    std::size_t run = 0, kept = 0;
    for (std::size_t t = 0; t <= stays.size(); ++t) {
        for (; run < mesh.runs.size() && mesh.runs[run].first_triangle == t; ++run)
            mesh.runs[run].first_triangle = kept;
        if (t < stays.size()) kept += stays[t];
    }
    keep(mesh.normal_index, stays);
    keep(mesh.uv_index, stays);
    keep(mesh.triangle_color, stays);
    keep(mesh.smoothing, stays);
    keep(mesh.index, stays);
    // Runs that became empty.
    std::vector<MeshRun> runs;
    for (std::size_t r = 0; r < mesh.runs.size(); ++r) {
        const std::size_t end =
            r + 1 < mesh.runs.size() ? mesh.runs[r + 1].first_triangle : mesh.index.size();
        if (mesh.runs[r].first_triangle < end) runs.push_back(std::move(mesh.runs[r]));
    }
    mesh.runs = std::move(runs);
}

} // namespace

void leave_out_not_finite(RawMesh& mesh, const std::string& name)
{
    const auto or_index = [&](const std::vector<glm::uvec3>& own) -> const auto&
    {
        return own.empty() ? mesh.index : own;
    };
    mesh.problems.add_times("normals that are not finite are computed",
        replace(mesh.normal, or_index(mesh.normal_index), glm::vec3(0)));
    mesh.problems.add_times("texture coordinates that are not finite are taken as 0",
        replace(mesh.uv, or_index(mesh.uv_index), glm::vec2(0)));
    mesh.problems.add_times("colours that are not finite are taken as white",
        replace(mesh.color, mesh.index, glm::vec4(1)));
    std::size_t bad_colors = 0;
    for (glm::vec4& color : mesh.triangle_color)
        if (!is_finite(color)) {
            color = glm::vec4(1);
            ++bad_colors;
        }
    mesh.problems.add_times("colours that are not finite are taken as white", bad_colors);

    std::vector<bool> known;
    for (std::size_t v = 0; v < mesh.position.size(); ++v)
        if (!is_finite(mesh.position[v])) {
            if (known.empty()) known.resize(mesh.position.size(), true);
            known[v] = false;
            mesh.position[v] = glm::vec3(0);
        }
    if (known.empty()) return;
    std::vector<bool> stays(mesh.index.size());
    std::size_t left_out = 0;
    for (std::size_t t = 0; t < mesh.index.size(); ++t) {
        const glm::uvec3& corners = mesh.index[t];
        stays[t] = known[corners.x] && known[corners.y] && known[corners.z];
        if (stays[t]) continue;
        ++left_out;
        mesh.problems.add(
            "triangles with a corner that is no finite float are left out", "triangle", t);
    }
    if (left_out == 0) return;
    if (left_out == stays.size())
        throw FileError(
            fmt::format("{}: no triangles in it: all {} have a corner that is no finite float",
                name, left_out));
    leave_out_triangles(mesh, stays);
}

void check_triangle_count(std::size_t count, const std::string& name)
{
    if (count == 0) throw FileError(fmt::format("{}: no triangles in it", name));
    if (count > kMaxFileTriangles)
        throw FileError(fmt::format(
            "{}: {} triangles, at most {} are accepted", name, count, kMaxFileTriangles));
}

} // namespace firsthit
