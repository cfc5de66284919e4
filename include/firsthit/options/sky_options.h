// sky_options.h - light that comes from all of the sky, and does not reach what is hidden from it.
#pragma once

#include <glm/vec3.hpp>

namespace firsthit {

/// An evenly bright sky over a dimmer ground.
///
/// The sky is a number of fixed directions, spread evenly over the upper hemisphere, each an exact
/// shadow ray. A point of unit normal n receives
///
///     color * S / F  +  ground * (1 - n.up) / 2 * (S + 0.02 F) / (S0 + 0.02 F)
///
/// where S is the sum of max(0, n.w) over the directions w that nothing hides, plus `bounce` times that of the
/// others; S0 is the sum over all directions, and F is S0 of a surface that faces up. So an open surface that faces
/// up receives exactly `color`, a vertical one about half of both, and one that faces down exactly `ground`. The
/// ground has no directions of its own: it is dimmed where the sky is hidden, and lights what faces down in full.
///
/// Materials send on what their diffuse colour leaves of it: Phong::diffuse, and base_color times (1 -
/// metallic) of MetallicRoughness; Unlit sends none. A surface that reflects an environment (Scene::environment)
/// receives no light of the sky. Instead the environment's diffuse light is dimmed by (S + 0.02 F) / (S0 +
/// 0.02 F), the share of the sky that is open to it.
///
/// The cpu and hybrid engines do that. The gpu engine lets all of the sky through, as if S / F were (1 +
/// n.up) / 2. The number of directions then only switches it on.
struct Sky {
    static constexpr int kMostDirections = 256;

    int directions = 0;     // 0 to kMostDirections; 0: no sky, and no ground
    glm::vec3 color{1.0f};  // linear Rec.709, 0 or more and finite
    glm::vec3 ground{0.3f}; // the same
    float bounce = 0;       // 0 to 1: the share of its light that a hidden direction sends, for the
                            // light that the surface there sends on; keeps rooms from being black
    glm::dvec3 up{0};       // towards the zenith, any length; 0: Camera::up
};

} // namespace firsthit
