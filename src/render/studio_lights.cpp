// studio_lights.cpp - light and background for scenes that bring none.
#include "scene/model/default_light.h"

#include <firsthit/studio.h>

#include <glm/common.hpp>

#include <algorithm>
#include <variant>

namespace firsthit {
namespace {

// A white matt surface that faces the key light and the zenith at once shows kStudioKey + kStudioSky, below 1.
constexpr float kStudioKey = 0.62f;
constexpr float kStudioSky = 0.36f;
constexpr float kStudioGround = 0.10f;
constexpr float kStudioBounce = 0.15f;
constexpr float kKeyWithAmbient = 0.75f;     // beside an ambient light of a fifth
constexpr float kKeyWithEnvironment = 0.55f; // beside studio_environment
constexpr float kStudioPi = 3.14159265f;

/// Between the brightness of white surfaces in the key light and that of black ones.
constexpr float kStudioBackground = 0.075f;

void remove_ambient(Scene& scene)
{
    for (Material& material : scene.materials)
        if (auto* phong = std::get_if<Phong>(&material.model))
            phong->ambient = glm::max(phong->ambient - phong->diffuse, glm::vec3(0));
}

} // namespace

bool has_own_lights(const Scene& scene)
{
    return std::any_of(scene.lights.begin(), scene.lights.end(),
        [](const Light& light) { return !is_default_light(light); });
}

void set_up_studio(Scene& scene, bool sky)
{
    scene.lights.clear();
    add_default_light(scene);
    Light& key = scene.lights.back();
    key.direction = {0.8, -1, -0.9};
    // A matt surface of a physical material sends 1 / pi of what falls on it to the eye.
    const bool physical = has_physical_materials(scene);
    const float share = physical && scene.environment.map ? kKeyWithEnvironment
                        : sky                             ? kStudioKey
                                                          : kKeyWithAmbient;
    key.color = glm::vec3(share * (physical ? kStudioPi : 1.0f));
    if (sky) remove_ambient(scene);
    if (scene.background == glm::vec3(0)) scene.background = glm::vec3(kStudioBackground);
}

Sky studio_sky()
{
    return {.directions = 24,
        .color = glm::vec3(kStudioSky),
        .ground = glm::vec3(kStudioGround),
        .bounce = kStudioBounce};
}

} // namespace firsthit
