// default_light.cpp - light for scenes that bring none.
#include "scene/model/default_light.h"

#include "scene/model/borrow.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace firsthit {

void add_default_light(Scene& scene)
{
    World world;
    pose(borrow(scene), scene.begin_s, world);
    const std::array<glm::vec3, 2> box = bounds(world);
    const glm::dvec3 middle = (glm::dvec3(box[0]) + glm::dvec3(box[1])) * 0.5;
    const Camera camera = scene.camera ? world.camera : framing_camera(world);

    const double distance = glm::length(middle - camera.eye);
    const glm::dvec3 forward = glm::normalize(camera.direction);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    Light light;
    light.position = camera.eye + distance * (0.5 * right + 0.7 * up);
    // Where the camera is degenerate the renderer says so.
    if (!std::isfinite(light.position.x + light.position.y + light.position.z))
        light.position = camera.eye;
    scene.lights.push_back(light);
}

} // namespace firsthit
