// brute_shadows_test.cpp - the quick oracle of shadows is the plain one.
#include "rays/brute_shadows.h"

#include "shadow/shadow_scenes.h"

#include <gtest/gtest.h>

namespace firsthit::test {
namespace {

class BruteShadows : public testing::TestWithParam<std::size_t> {};

TEST_P(BruteShadows, LeavesOutOnlyWhatCannotShadow)
{
    const ShadowScene& scene = shadow_scenes()[GetParam()];
    const ShadowWorld made = make_shadow_world(scene, 1);
    const World& world = made.world.world;
    const ShadowPoints asked = shadow_points(made, 1500, 2);
    Tasks tasks(2);
    for (const Light& light : world.lights) {
        const PencilSpace space = light_space(light, made.view.camera.eye);
        const std::vector<glm::vec3> corner = all_to_light(space, world.position),
                                     point = all_to_light(space, asked.point);
        const LightTriangles triangles{corner, world.scene->index};
        for (const bool with_receivers : {true, false}) {
            std::vector<std::uint32_t> receivers;
            if (with_receivers) receivers = asked.receiver;
            std::vector<std::uint8_t> shadowed(point.size(), 7);
            brute_shadows(space, triangles, point, receivers, shadowed, tasks);
            Effort effort;
            for (std::size_t k = 0; k < point.size(); ++k) {
                const std::uint32_t receiver = with_receivers ? receivers[k] : kNoItem;
                ASSERT_EQ(
                    shadowed[k], is_shadowed_brute(space, triangles, point[k], receiver, effort))
                    << scene.name << ", point " << k;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Adversarial, BruteShadows,
    testing::Range(std::size_t(0), shadow_scenes().size()),
    [](const testing::TestParamInfo<std::size_t>& scene) {
        return shadow_test_name(shadow_scenes()[scene.param]);
    });

TEST(BruteShadowsOfNothing, LeaveEverythingLit)
{
    Tasks tasks(1);
    std::vector<std::uint8_t> shadowed(3, 7);
    const std::vector<glm::vec3> points(3, glm::vec3(1));
    brute_shadows({}, {}, points, {}, shadowed, tasks);
    EXPECT_EQ(shadowed, std::vector<std::uint8_t>(3, 0));
    brute_shadows({}, {}, {}, {}, {}, tasks);
}

} // namespace
} // namespace firsthit::test
