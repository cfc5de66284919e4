// scene_from_arrays.cpp - a scene from what a caller has in memory.
#include "scene/model/check_scene.h"
#include "scene/model/default_light.h"
#include "scene/model/default_material.h"
#include "scene/model/smooth_normals.h"

#include <firsthit/error.h>
#include <firsthit/scene.h>

#include <fmt/format.h>

#include <cmath>
#include <span>
#include <utility>

namespace firsthit {
namespace {

/// Gives every triangle its own three vertices, with the normal of its plane.
void make_flat(std::vector<glm::vec3>& position, std::vector<glm::uvec3>& index,
    std::vector<glm::vec3>& normal, std::vector<glm::vec2>& uv)
{
    const auto triangles = static_cast<std::uint32_t>(index.size());
    std::vector<glm::vec3> corner_position;
    std::vector<glm::vec2> corner_uv;
    corner_position.reserve(index.size() * 3);
    normal.reserve(index.size() * 3);
    for (std::uint32_t t = 0; t < triangles; ++t) {
        for (int k = 0; k < 3; ++k) {
            corner_position.push_back(position[index[t][k]]);
            if (!uv.empty()) corner_uv.push_back(uv[index[t][k]]);
        }
        const glm::uvec3 own(3 * t, 3 * t + 1, 3 * t + 2);
        const std::span<const glm::vec3> corners(&corner_position[own.x], 3);
        const glm::uvec3 first(0, 1, 2);
        const SmoothNormals flat = smooth_normals(corners, std::span(&first, 1), 0.0);
        for (int k = 0; k < 3; ++k)
            normal.push_back(flat.normal[flat.corner[static_cast<std::size_t>(k)]]);
        index[t] = own;
    }
    position = std::move(corner_position);
    uv = std::move(corner_uv);
}

/// Before vertices that no triangle uses go away with their damage.
void check_finite(const std::vector<glm::vec3>& position)
{
    for (std::size_t v = 0; v < position.size(); ++v)
        for (int axis = 0; axis < 3; ++axis)
            if (!std::isfinite(position[v][axis]))
                throw SceneError(fmt::format(
                    "vertex {}: {} is {}, not a finite number", v, "xyz"[axis], position[v][axis]));
}

void check_index(const std::vector<glm::uvec3>& index, std::size_t vertices)
{
    for (std::size_t t = 0; t < index.size(); ++t)
        for (int k = 0; k < 3; ++k)
            if (index[t][k] >= vertices)
                throw SceneError(fmt::format("triangle {}: vertex {} is out of range ({} vertices)",
                    t, index[t][k], vertices));
}

} // namespace

Scene scene_from_arrays(std::vector<glm::vec3> position, std::vector<glm::uvec3> index,
    std::vector<glm::vec3> normal, std::vector<glm::vec2> uv)
{
    if (!normal.empty() && normal.size() != position.size())
        throw SceneError(
            fmt::format("{} normals for {} positions", normal.size(), position.size()));
    if (!uv.empty() && uv.size() != position.size())
        throw SceneError(
            fmt::format("{} texture coordinates for {} positions", uv.size(), position.size()));
    check_finite(position);
    check_index(index, position.size());
    if (normal.empty()) {
        if (index.size() > kNoItem / 3)
            throw SceneError(fmt::format("{} triangles without normals, at most {} are accepted",
                index.size(), kNoItem / 3));
        make_flat(position, index, normal, uv);
    }

    Scene scene;
    scene.name = "arrays";
    scene.nodes.push_back({.name = "arrays"});
    scene.materials.push_back(default_material());
    scene.ambient = glm::vec3(kMeshAmbient);
    scene.vertices = position.size();
    scene.owner.assign(index.size(), 0);
    Part& part = scene.parts.emplace_back();
    part.name = "arrays";
    part.vertex_count = static_cast<std::uint32_t>(position.size());
    part.triangle_count = static_cast<std::uint32_t>(index.size());
    scene.position = std::move(position);
    scene.normal = std::move(normal);
    scene.uv = std::move(uv);
    scene.index = std::move(index);
    check_scene(scene);
    add_default_light(scene);
    return scene;
}

} // namespace firsthit
