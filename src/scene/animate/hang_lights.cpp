// hang_lights.cpp - lights that go with the camera.
#include <firsthit/scene.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>

namespace firsthit {

void hang_lights(const Camera& camera, World& world)
{
    if (!world.scene) return;
    const glm::dvec3 back = -glm::normalize(camera.direction);
    const glm::dvec3 right = glm::normalize(glm::cross(camera.up, back));
    const glm::dvec3 up = glm::cross(back, right);
    if (!std::isfinite(right.x + right.y + right.z)) return; // the renderer says what is wrong
    for (std::size_t l = 0; l < world.lights.size() && l < world.scene->lights.size(); ++l) {
        const Light& given = world.scene->lights[l];
        if (!given.on_camera) continue;
        const auto turned = [&](const glm::dvec3& v) {
            return v.x * right + v.y * up + v.z * back;
        };
        world.lights[l].position = camera.eye + turned(given.position);
        world.lights[l].direction = turned(given.direction);
    }
}

} // namespace firsthit
