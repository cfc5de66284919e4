// shadow_scenes.h - adversarial scenes: their shadows are wrong if they are not computed exactly.
#pragma once

#include "lights.h"
#include "scenes.h"

#include <functional>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace firsthit::test {

/// A world with lights, and an eye that sees it.
struct ShadowWorld {
    TestWorld world; // includes its lights
    View view;       // kShadowSize pixels on a side
    float scale = 1; // typical size of its coordinates
};

struct ShadowScene {
    std::string name;
    std::function<void(ShadowWorld&, std::mt19937&)> fill;
};

inline constexpr int kShadowSize = 64;

const std::vector<ShadowScene>& shadow_scenes();

/// The scene's name without characters that the name of a test must not have.
std::string shadow_test_name(const ShadowScene& scene);

/// Makes the world of a scene, ready for use.
ShadowWorld make_shadow_world(const ShadowScene& scene, unsigned seed);

/// Points in world space that are hard to decide: on triangles, their corners and edges, just
/// beside them, between them and the lights, at the lights, anywhere, and not usable (NaN, 1e30).
/// For each point the triangle that it lies on, or kNoItem.
struct ShadowPoints {
    std::vector<glm::vec3> point;
    std::vector<std::uint32_t> receiver;
};
ShadowPoints shadow_points(const ShadowWorld& world, std::size_t count, unsigned seed);

} // namespace firsthit::test
