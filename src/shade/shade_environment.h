// shade_environment.h - the environment in the form that shading needs, computed once for each tile.
#pragma once

#include <firsthit/scene.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace firsthit {

struct ShadeEnvironment {
    const float* texel = nullptr; // EnvironmentMap::texels(); null: there is no environment
    const glm::vec3* diffuse = nullptr;
    /// Of the levels; as long as a register.
    alignas(64) std::array<float, 16> side{}, first{};
    float table = 0;            // index of the table
    float cosine = 1, sine = 0; // of the rotation
    float strength = 1;

    bool any() const { return texel != nullptr; }
};

/// Whether the scene's environment is seen where nothing else is.
inline bool shows_environment(const Scene& scene)
{
    return scene.environment.map && scene.environment.background;
}

inline ShadeEnvironment shade_environment(const Environment& environment)
{
    ShadeEnvironment shade;
    if (!environment.map) return shade;
    const EnvironmentMap& map = *environment.map;
    static_assert(sizeof(glm::vec4) == 4 * sizeof(float));
    shade.texel = &map.texels()[0].x;
    shade.diffuse = map.diffuse().data();
    for (std::size_t k = 0; k < EnvironmentMap::kLevels; ++k) {
        shade.side[k] = static_cast<float>(map.sides()[k]);
        shade.first[k] = static_cast<float>(map.first()[k]);
    }
    shade.table = static_cast<float>(map.table());
    shade.cosine = static_cast<float>(std::cos(environment.rotation_rad));
    shade.sine = static_cast<float>(std::sin(environment.rotation_rad));
    shade.strength = environment.strength;
    return shade;
}

} // namespace firsthit
