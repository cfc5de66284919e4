// scene_from_arrays.cpp - a scene from what a caller has in memory.
#include "scene/model/default_light.h"
#include "scene/model/default_material.h"

#include <firsthit/error.h>
#include <firsthit/scene.h>
#include <firsthit/scene_builder.h>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace firsthit {
namespace {

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
    SceneBuilder builder("arrays");
    builder.set_ambient(glm::vec3(kMeshAmbient));
    Mesh mesh;
    mesh.position = std::move(position);
    mesh.normal = std::move(normal);
    mesh.uv = std::move(uv);
    mesh.index = std::move(index);
    const std::uint32_t node = builder.add_node({.name = "arrays"});
    const std::uint32_t material = builder.add_material(default_material());
    builder.add_instance(builder.add_mesh(std::move(mesh)), node, material);
    Scene scene = builder.build();
    add_default_light(scene);
    return scene;
}

} // namespace firsthit
