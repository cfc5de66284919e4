// near_margins_test.cpp - points so near to a margin or a light that only exact predicates are
// right.
#include "rays/brute_shadows.h"
#include "shadow/shadow_scenes.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

#include <random>

namespace firsthit::test {
namespace {

/// Tests all points and expects the answers of brute force. Returns how many points are occluded.
std::size_t expect_brute_force(
    TestWorld& world, const Light& light, const std::vector<glm::vec3>& points)
{
    world.finish();
    const PencilSpace space = light_space(light, glm::dvec3(0));
    const std::vector<glm::vec3> corner = all_to_light(space, world.world.position);
    std::vector<std::uint8_t> occluded;
    Occlusion(2).test(world.world, points, light, occluded);
    std::size_t wrong = 0, dark = 0;
    Effort effort;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const bool expected = is_shadowed_brute(
            space, {corner, world.scene->index}, to_light(space, points[k]), kNoItem, effort);
        wrong += occluded[k] != expected;
        dark += expected;
    }
    EXPECT_EQ(wrong, 0u);
    return dark;
}

/// Random points on a horizontal square.
std::vector<glm::vec3> square(const glm::vec3& middle, float half, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> side(-half, half);
    std::vector<glm::vec3> points;
    for (int k = 0; k < 2000; ++k)
        points.push_back(middle + glm::vec3(side(random), 0, side(random)));
    return points;
}

void add_roof(TestWorld& world, const glm::vec3& middle, float half)
{
    world.add(middle + glm::vec3(-half, 0, -half), middle + glm::vec3(half, 0, -half),
        middle + glm::vec3(0, 0, 2 * half));
}

TEST(NearMargins, PointsJustUnderARoofFarFromTheOriginAreLit)
{
    TestWorld world;
    add_roof(world, {1000, 1000, 1000}, 3);
    const Light light = point_light({1000, 1003, 1000});
    // The margin is 4.8e-4, most of which is 2^-21 times the light's distance from the origin.
    EXPECT_EQ(expect_brute_force(world, light, square({1000, 1000 - 3e-4f, 1000}, 0.4f, 1)), 0u);
    EXPECT_EQ(expect_brute_force(world, light, square({1000, 1000 - 6e-4f, 1000}, 0.4f, 1)), 2000u);
}

TEST(NearMargins, PointsJustUnderAVeryLargeRoofAreLit)
{
    TestWorld world;
    add_roof(world, {0, 0, 0}, 1e4f);
    for (const Light& light : {point_light({0, 3, 0}), directional_light({0.1, -1, 0.2})}) {
        EXPECT_EQ(expect_brute_force(world, light, square({0, -3e-3f, 0}, 0.4f, 2)), 0u);
        EXPECT_EQ(expect_brute_force(world, light, square({0, -3e-2f, 0}, 0.4f, 2)), 2000u);
    }
}

TEST(NearMargins, DepthSlopesOfAPlaneNearlyThroughALightMayOverflow)
{
    // On the face +z the plane y = h has the depth w = Y / h.
    TestWorld world;
    const float h = 0x1p-135f;
    world.add({-1, h, -1}, {1, h, -1}, {0, h, 1});
    std::mt19937 random(1);
    std::uniform_real_distribution<float> x(-0.3f, 0.3f), y(0, 2e-5f);
    std::vector<glm::vec3> points;
    for (int k = 0; k < 500; ++k) points.push_back({x(random), y(random), 1});
    EXPECT_GT(expect_brute_force(world, point_light({0, 0, 0}), points), 300u);
}

TEST(NearMargins, OfTinyScenesMayBeDenormal)
{
    const float unit = std::numeric_limits<float>::denorm_min();
    std::mt19937 random(2);
    const auto whole = [&](int low, int high) {
        return std::uniform_int_distribution<int>(low, high)(random);
    };
    // A triangle in the plane x + y = 4096 units, whose corners lie in it exactly.
    TestWorld world;
    const auto corner = [&](int m, float z) {
        return glm::vec3(float(m) * 0x1p-137f, float(1 - m) * 0x1p-137f, z);
    };
    world.add(
        corner(-12345677, -0x1p-113f), corner(13456789, -0x1p-113f), corner(54321, 0x1p-113f));
    const PencilSpace space;
    const Corners corners{
        world.world.position[0], world.world.position[1], world.world.position[2]};
    std::vector<glm::vec3> points;
    for (int k = 0; k < 2000; ++k) {
        const float z = 0x1p-115f * (1 + 0x1p-20f * float(whole(0, 1 << 19)));
        const double margin =
            double(shadow_margin(space, {0, 0, z})) + double(corner_margin(corners));
        const int height = 4096 + int(2 * margin / double(unit)) + whole(-3, 3),
                  x = whole(-1000, 1000);
        points.push_back({float(x) * unit, float(height - x) * unit, z});
    }
    const std::size_t dark = expect_brute_force(world, point_light({0, 0, 0}), points);
    EXPECT_GT(dark, 500u);
    EXPECT_LT(dark, 1500u);
}

} // namespace
} // namespace firsthit::test
