// one_light.cpp - the light of scenes that are measured.
#include "bench/measure/one_light.h"

#include <glm/geometric.hpp>

#include <array>
#include <memory>
#include <utility>

namespace firsthit::cli::bench {

void leave_one_light(Scene& scene)
{
    if (scene.lights.size() > 1) scene.lights.resize(1);
    if (scene.lights.empty() || !scene.lights[0].on_camera) return;

    World world; // has the scene for a while
    const double begin_s = scene.begin_s();
    const auto shared = std::make_shared<Scene>(std::move(scene));
    pose(std::shared_ptr<const Scene>(shared), begin_s, world);
    const std::array<glm::vec3, 2> box = bounds(world);
    const glm::dvec3 middle = (glm::dvec3(box[0]) + glm::dvec3(box[1])) * 0.5;
    const Camera& camera = world.camera;
    const double distance = glm::length(middle - camera.eye);
    const glm::dvec3 forward = glm::normalize(camera.direction);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    scene = std::move(*shared);
    scene.lights[0] =
        Light{.position = camera.eye + distance * (0.5 * right + 0.7 * up), .name = "bench"};
}

} // namespace firsthit::cli::bench
