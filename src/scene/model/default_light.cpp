// default_light.cpp - light for scenes that bring none.
#include "scene/model/default_light.h"

#include <algorithm>
#include <variant>

namespace firsthit {

namespace {
constexpr const char* kDefaultName = "default"; // lights of files do not hang on the camera
}

bool has_physical_materials(const Scene& scene)
{
    return std::any_of(scene.materials.begin(), scene.materials.end(),
        [](const Material& m) { return std::holds_alternative<MetallicRoughness>(m.model); });
}

void add_default_light(Scene& scene)
{
    Light light;
    light.kind = Light::Kind::directional;
    light.direction = {0.5, -0.8, -1};
    light.on_camera = true;
    light.name = kDefaultName;
    // A matt surface sends 1 / pi of what falls on it to the eye; Phong's formula leaves that out. A third
    // is left to the light from all around.
    if (has_physical_materials(scene)) light.color = glm::vec3(2.0f / 3 * 3.14159265f);
    scene.lights.push_back(light);
}

bool is_default_light(const Light& light)
{
    return light.on_camera && light.name == kDefaultName;
}

} // namespace firsthit
