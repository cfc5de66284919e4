// shadow_scenes.h - triangles, lights and eyes that break shadows which are only nearly right.
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
    TestWorld world; // its lights are set too
    View view;       // kShadowSize pixels on a side
    float scale = 1; // of its coordinates
};

struct ShadowScene {
    std::string name;
    std::function<void(ShadowWorld&, std::mt19937&)> fill;
};

inline constexpr int kShadowSize = 64;

const std::vector<ShadowScene>& shadow_scenes();

/// The scene's name with nothing in it that a test's name may not have.
std::string shadow_test_name(const ShadowScene& scene);

/// A finished world of one scene.
ShadowWorld make_shadow_world(const ShadowScene& scene, unsigned seed);

/// Points in world space that are worth asking about: on triangles, their corners and edges, a hair
/// beside them, between them and the lights, at the lights, anywhere, nowhere (NaN, 1e30). For each
/// the triangle that it lies on, or kNoItem.
struct ShadowPoints {
    std::vector<glm::vec3> point;
    std::vector<std::uint32_t> receiver;
};
ShadowPoints shadow_points(const ShadowWorld& world, std::size_t count, unsigned seed);

} // namespace firsthit::test
