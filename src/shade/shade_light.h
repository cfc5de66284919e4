// shade_light.h - lights as the loop over samples reads them, worked out once a tile.
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
    glm::vec3 to_light{0}; // directional: unit
    SpotCone cone{};       // spot
};

inline ShadeLight shade_light(const Light& light)
{
    ShadeLight shade{.kind = light.kind, .color = light.color};
    shade.position = glm::vec3(light.position);
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

/// The lights of a world. Without memory of its own beyond the stack: lights after the first
/// kKept are worked out wherever they are asked for, which costs them about 10 ns a register.
class ShadeLights {
  public:
    static constexpr std::size_t kKept = 16;

    explicit ShadeLights(const std::vector<Light>& lights) : lights_(lights)
    {
        for (std::size_t l = 0; l < std::min(kKept, lights.size()); ++l)
            kept_[l] = shade_light(lights[l]);
    }

    std::size_t size() const { return lights_.size(); }

    /// spare  holds a light that is not kept
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
