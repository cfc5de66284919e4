// scenes.h - worlds from a few lines, for tests.
#pragma once

#include <firsthit/scene.h>

#include <cmath>
#include <memory>
#include <vector>

namespace firsthit::test {

/// A posed world that owns its scene: one instance, one grey material, no lights.
struct TestWorld {
    std::shared_ptr<Scene> scene = std::make_shared<Scene>();
    World world;

    void add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
    {
        const auto first = std::uint32_t(world.position.size());
        for (const glm::vec3& corner : {a, b, c}) world.position.push_back(corner);
        scene->index.push_back({first, first + 1, first + 2});
    }

    /// Makes the world consistent after its positions and indices were filled in.
    const World& finish()
    {
        scene->vertices = world.position.size();
        scene->position = world.position;
        world.normal.assign(world.position.size(), glm::vec3(0, 0, 1));
        scene->normal = world.normal;
        scene->owner.assign(scene->index.size(), 0);
        scene->nodes = {Node{}};
        scene->materials = {Material{}};
        Instance instance;
        instance.vertex_count = std::uint32_t(world.position.size());
        instance.triangle_count = std::uint32_t(scene->index.size());
        scene->instances = {instance};
        world.scene = scene;
        world.node_matrix = {glm::dmat4(1.0)};
        world.node_visible = {1};
        return world;
    }
};

/// A camera at the origin that looks along +z with +y down: its axes are the eye's, so that world
/// coordinates times f are eye space. With fov_y = 2 atan(height / 2 / f).
inline View straight_view(int width, int height, double f)
{
    View view;
    view.width = width;
    view.height = height;
    view.camera.eye = {0, 0, 0};
    view.camera.direction = {0, 0, 1};
    view.camera.up = {0, -1, 0};
    view.camera.fov_y_rad = 2 * std::atan(0.5 * height / f);
    return view;
}

} // namespace firsthit::test
