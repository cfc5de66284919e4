// flatten.cpp - a scene at one time, without what moves it.
#include "readers/sequence/flatten.h"

#include "scene/model/borrow.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace firsthit {
namespace {

/// Whether posing would change nothing, as of mesh files.
bool is_flat(const Scene& scene)
{
    const auto stays = [](const Node& node) {
        return !node.transform && node.local == glm::dmat4(1.0);
    };
    const auto keeps_shape = [](const Instance& instance) { return !instance.changes_shape(); };
    return scene.clips.empty() && std::all_of(scene.nodes.begin(), scene.nodes.end(), stays) &&
           std::all_of(scene.instances.begin(), scene.instances.end(), keeps_shape);
}

} // namespace

void flatten(Scene& scene)
{
    if (is_flat(scene)) return;
    World world;
    pose(borrow(scene), scene.begin_s(), world);

    scene.position = std::move(world.position);
    scene.normal = std::move(world.normal);
    scene.tangent = std::move(world.tangent);
    scene.lights = std::move(world.lights);
    for (Light& light : scene.lights) light.node = -1;
    for (SceneCamera& camera : scene.cameras) {
        if (camera.node < 0) continue;
        const glm::dmat4& matrix = world.node_matrix[static_cast<std::size_t>(camera.node)];
        camera.camera.eye = glm::dvec3(matrix * glm::dvec4(camera.camera.eye, 1));
        camera.camera.direction = glm::dmat3(matrix) * camera.camera.direction;
        camera.camera.up = glm::dmat3(matrix) * camera.camera.up;
        camera.node = -1;
    }
    for (Instance& instance : scene.instances) {
        instance.morph.clear();
        instance.deform = nullptr;
        instance.shape = -1;
        instance.skin = -1;
        instance.facet_normals = false;
    }
    for (Node& node : scene.nodes) node = Node{.name = std::move(node.name)};
    scene.clips.clear();
    scene.shapes.clear();
    scene.skins.clear();
}

} // namespace firsthit
