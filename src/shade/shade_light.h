// shade_light.h - lights in the form that shading needs, computed once for each tile.
#pragma once

#include "hits/spot_cone.h"

#include <firsthit/scene.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace firsthit {

struct ShadeLight {
    Light::Kind kind = Light::Kind::point;
    glm::vec3 color{1};
    glm::vec3 position{0}; // point, spot
    glm::vec3 to_light{0}; // directional: unit vector towards the light
    SpotCone cone{};       // spot
    float inv_range2 =
        -1; // below 0: it does not fade with distance; else see src/glsl/falloff.glsl
};

inline ShadeLight shade_light(const Light& light)
{
    ShadeLight shade{.kind = light.kind, .color = light.color};
    shade.position = glm::vec3(light.position);
    if (light.inverse_square && light.kind != Light::Kind::directional)
        shade.inv_range2 = light.range > 0
                               ? static_cast<float>(std::min(1 / (light.range * light.range), 1e30))
                               : 0.0f;
    switch (light.kind) {
    case Light::Kind::point:
        break;
    case Light::Kind::spot:
        shade.cone = spot_cone(light);
        break;
    case Light::Kind::directional:
        shade.to_light = glm::vec3(-glm::normalize(light.direction));
        break;
    }
    return shade;
}

/// The lights of a world. Allocates nothing: it keeps the first kKept lights, and computes each
/// later one again in every call of at(), which costs about 10 ns for each register of samples.
class ShadeLights {
  public:
    static constexpr std::size_t kKept = 16;

    explicit ShadeLights(const std::vector<Light>& lights) : lights_(lights)
    {
        for (std::size_t l = 0; l < std::min(kKept, lights.size()); ++l)
            kept_[l] = shade_light(lights[l]);
    }

    std::size_t size() const { return lights_.size(); }

    /// spare  memory for a light that is not kept; the result may refer to it
    const ShadeLight& at(std::size_t light, ShadeLight& spare) const
    {
        if (light < kKept) return kept_[light];
        spare = shade_light(lights_[light]);
        return spare;
    }

  private:
    const std::vector<Light>& lights_;
    std::array<ShadeLight, kKept> kept_;
};

} // namespace firsthit
