// exact_shadows_test.cpp - exact shadows of pictures and of points equal brute force.
#include "rays/brute_shadows.h"
#include "shadow/shadow_scenes.h"
#include "instruction_sets.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

namespace firsthit::test {
namespace {

class ExactShadows : public testing::TestWithParam<std::size_t> {
  protected:
    const ShadowScene& scene = shadow_scenes()[GetParam()];
};

TEST_P(ExactShadows, OfAPictureEqualBruteForce)
{
    for (unsigned seed = 0; seed < 2; ++seed) {
        const ShadowWorld made = make_shadow_world(scene, seed);
        const LitComparison c = compare_lit(made.world.world, made.view, Oracle::brute, 2);
        EXPECT_EQ(c.ours_wrong, 0u) << scene.name << ", seed " << seed;
        EXPECT_EQ(c.theirs_wrong, 0u) << scene.name << ", seed " << seed;
        EXPECT_EQ(c.agree, c.pixels);
        EXPECT_GT(c.pixels, 500u * made.world.world.lights.size()) << "the eye sees too little";
    }
}

TEST_P(ExactShadows, OfPointsEqualBruteForce)
{
    const ShadowWorld made = make_shadow_world(scene, 3);
    const World& world = made.world.world;
    const ShadowPoints points = shadow_points(made, 2000, 4);
    Occlusion occlusion(2);
    for (Light light : world.lights) {
        if (light.kind == Light::Kind::spot) light.kind = Light::Kind::point;
        const PencilSpace space = light_space(light, glm::dvec3(0));
        const std::vector<glm::vec3> corner = all_to_light(space, world.position);
        const LightTriangles triangles{corner, world.scene->index};
        std::vector<std::uint8_t> with, without;
        occlusion.test(world, points.point, light, with, points.receiver);
        occlusion.test(world, points.point, light, without);
        Effort effort;
        for (std::size_t k = 0; k < points.point.size(); ++k) {
            const glm::vec3 d = to_light(space, points.point[k]);
            ASSERT_EQ(without[k], is_shadowed_brute(space, triangles, d, kNoItem, effort))
                << scene.name << ", point " << k;
            const std::uint32_t receiver = points.receiver[k];
            glm::vec3 up = d;
            if (receiver != kNoItem) {
                const Corners c = triangles[receiver];
                up = lifted(space, d, receiver_of(c, light_side(space, c, effort)));
            }
            ASSERT_EQ(with[k], is_shadowed_brute(space, triangles, up, receiver, effort))
                << scene.name << ", point " << k << " on " << receiver;
        }
    }
}

TEST_P(ExactShadows, AreTheSameForEveryInstructionSetAndThreadCount)
{
    const ShadowWorld made = make_shadow_world(scene, 5);
    const ShadowPoints points = shadow_points(made, 3000, 6);
    const auto bits = [&](int threads) {
        std::vector<std::uint8_t> packed;
        Occlusion(threads).test_packed(
            made.world.world, points.point, made.world.world.lights, packed, points.receiver);
        return packed;
    };
    const std::vector<std::uint8_t> expected = bits(1);
    EXPECT_EQ(bits(7), expected);
    for_instruction_sets([&] { EXPECT_EQ(bits(2), expected); });
}

INSTANTIATE_TEST_SUITE_P(Adversarial, ExactShadows,
    testing::Range(std::size_t(0), shadow_scenes().size()),
    [](const testing::TestParamInfo<std::size_t>& scene) {
        return shadow_test_name(shadow_scenes()[scene.param]);
    });

} // namespace
} // namespace firsthit::test
