// grid_shadows_test.cpp - shadows by a sample grid equal those of testing all pairs, and
// those by patches and cells.
#include "instruction_sets.h"
#include "shadow/exact/planned_shadows.h"
#include "shadow/shadow_builder.h"

#include <gtest/gtest.h>

#include <cctype>
#include <numeric>

namespace firsthit::test {
namespace {

class GridShadows : public testing::TestWithParam<std::size_t> {
  protected:
    const ShadowScene& scene = shadow_scenes()[GetParam()];
};

TEST_P(GridShadows, EqualBruteForce)
{
    const ShadowWorld made = make_shadow_world(scene, 7);
    const World& world = made.world.world;
    const ShadowPoints asked = shadow_points(made, 1500, 8);
    for (Light light : world.lights) {
        if (light.kind == Light::Kind::spot) light.kind = Light::Kind::point;
        const PencilSpace space = light_space(light, glm::dvec3(0));
        EXPECT_EQ(
            shadows(world, space, asked, ShadowPlan::grid, 2), plain_shadows(world, space, asked))
            << scene.name;
    }
}

TEST_P(GridShadows, AreTheSameForEveryInstructionSet)
{
    const ShadowWorld made = make_shadow_world(scene, 9);
    const World& world = made.world.world;
    const ShadowPoints asked = shadow_points(made, 3000, 10);
    for (const Light& light : world.lights) {
        const PencilSpace space = light_space(light, glm::dvec3(0));
        const auto expected = shadows(world, space, asked, ShadowPlan::cells, 1);
        for_instruction_sets(
            [&] { EXPECT_EQ(shadows(world, space, asked, ShadowPlan::grid, 3), expected); });
    }
}

INSTANTIATE_TEST_SUITE_P(Adversarial, GridShadows,
    testing::Range(std::size_t(0), shadow_scenes().size()),
    [](const testing::TestParamInfo<std::size_t>& scene) {
        return shadow_test_name(shadow_scenes()[scene.param]);
    });

/// A hilly sheet of 2 n n triangles under a light, with points at corners, on edges and inside of
/// triangles.
struct Sheet {
    TestWorld world;
    ShadowPoints asked;
    PencilSpace space;

    Sheet(int n, float size, float receiver_slope, bool snapped, const Light& light)
    {
        std::mt19937 random{unsigned(n)};
        ShadowWorld made;
        Builder build{made, random};
        build.grid(n, [&](int i, int j) {
            const float x = 2 * float(i) / float(n) - 1, z = 2 * float(j) / float(n) - 1;
            float y =
                receiver_slope * (std::sin(9 * x) * std::cos(7 * z) + 0.2f * std::sin(80 * x));
            if (snapped) y = std::round(y * 64) / 64;
            return size * glm::vec3(x, y, z);
        });
        world = std::move(made.world);
        world.world.scene = world.scene;
        const auto& index = world.scene->index;
        for (int k = 0; k < 4000; ++k) {
            const auto t = std::uint32_t(whole(random, 0, int(index.size()) - 1));
            const glm::uvec3 c = index[t];
            const float weight[4] = {0, 0.5f, 1, uniform(random, 0, 1)};
            const float u = weight[whole(random, 0, 3)], v = (1 - u) * weight[whole(random, 0, 3)];
            const auto& p = world.world.position;
            asked.point.push_back((1 - u - v) * p[c.x] + u * p[c.y] + v * p[c.z]);
            asked.receiver.push_back(k % 5 ? t : kNoItem);
        }
        space = light_space(light, glm::dvec3(0));
    }
};

TEST(GridShadowsOfSheets, EqualThoseOfPatchesAndCells)
{
    for (const bool snapped : {false, true}) {
        for (const float size : {1e-6f, 1.0f, 3e4f}) {
            int all_dark = 0;
            for (const Light& light : {point_light(glm::dvec3(0.3, 1.1, 0.2) * double(size)),
                     point_light(glm::dvec3(-3, 0.4, 2) * double(size)),
                     directional_light({0, -1, 0}), directional_light({1, -0.3, 0.2})}) {
                const Sheet sheet(60, size, 0.3f, snapped, light);
                const auto cells =
                    shadows(sheet.world.world, sheet.space, sheet.asked, ShadowPlan::cells, 1);
                const auto grid =
                    shadows(sheet.world.world, sheet.space, sheet.asked, ShadowPlan::grid, 2);
                EXPECT_EQ(grid, cells);
                const auto dark = std::accumulate(cells.begin(), cells.end(), 0);
                all_dark += dark;
            }
            EXPECT_GT(all_dark, 500) << "nothing to find";
            EXPECT_LT(all_dark, 15500) << "nothing to find";
        }
    }
}

TEST(GridShadowsOfSheets, LeaveCrowdedSamplesToTheCells)
{
    // All but one of 20,000 points lie within a square of 1 / 200,000 of the grid's side.
    const Light light = directional_light({0, -1, 0});
    Sheet sheet(60, 1, 0.3f, false, light);
    std::mt19937 random(3);
    sheet.asked = {};
    for (int k = 0; k < 20000; ++k)
        sheet.asked.point.push_back(
            {uniform(random, 0, 1e-3f), uniform(random, -2, 0.5f), uniform(random, 0, 1e-3f)});
    sheet.asked.point.push_back({200, 0, 200});
    const auto expected =
        shadows(sheet.world.world, sheet.space, sheet.asked, ShadowPlan::cells, 1);
    EXPECT_EQ(
        shadows(sheet.world.world, sheet.space, sheet.asked, ShadowPlan::automatic, 1), expected);
    EXPECT_EQ(shadows(sheet.world.world, sheet.space, sheet.asked, ShadowPlan::grid, 1), expected);
}

} // namespace
} // namespace firsthit::test
