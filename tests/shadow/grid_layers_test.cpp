// grid_layers_test.cpp - exact shadows where the grid of samples takes short cuts: layers behind all
// samples, samples that one wide face sees, places that are coarser than the roundings before them.
#include "instruction_sets.h"
#include "shadow/planned_shadows.h"
#include "shadow/shadow_builder.h"

#include <gtest/gtest.h>

#include <numeric>

namespace firsthit::test {
namespace {

/// Wavy sheets of 2 n n triangles across the z axis, one behind the other.
struct Layers {
    TestWorld world;

    Layers(int n, int layers, const glm::vec3& middle, float size)
    {
        std::mt19937 random{5};
        ShadowWorld made;
        Builder build{made, random};
        for (int layer = 0; layer < layers; ++layer) {
            build.grid(n, [&](int i, int j) {
                const float x = 2 * float(i) / float(n) - 1, y = 2 * float(j) / float(n) - 1;
                const float wave = 0.1f * std::sin(8 * x + float(layer)) * std::cos(7 * y);
                return middle + size * glm::vec3(x, y, 0.15f * float(layer) + wave);
            });
        }
        world = std::move(made.world);
        world.world.scene = world.scene.get();
    }

    /// Points on triangles: corners, edges and middles.
    ShadowPoints points(int count) const
    {
        std::mt19937 random{7};
        ShadowPoints asked;
        const auto& index = world.scene->index;
        const auto& p = world.world.position;
        for (int k = 0; k < count; ++k) {
            const auto t = std::uint32_t(whole(random, 0, int(index.size()) - 1));
            const float u = k % 3 ? uniform(random, 0, 1) : 0.5f;
            const float v = k % 4 ? (1 - u) * uniform(random, 0, 1) : 0;
            const glm::uvec3 c = index[t];
            asked.point.push_back((1 - u - v) * p[c.x] + u * p[c.y] + v * p[c.z]);
            asked.receiver.push_back(k % 5 ? t : kNoItem);
        }
        return asked;
    }
};

/// Both plans, on every instruction set, are the plain loop.
void expect_plain_shadows(const World& world, const Light& light, const ShadowPoints& asked)
{
    const LightSpace space = light_space(light, glm::dvec3(0));
    const auto expected = plain_shadows(world, space, asked);
    const auto dark = std::size_t(std::accumulate(expected.begin(), expected.end(), 0));
    EXPECT_GT(dark, asked.point.size() / 20) << "nothing to find";
    EXPECT_LT(dark, asked.point.size() * 19 / 20) << "nothing to find";
    for_instruction_sets([&] {
        EXPECT_EQ(shadows(world, space, asked, ShadowPlan::grid), expected);
        EXPECT_EQ(shadows(world, space, asked, ShadowPlan::cells), expected);
    });
}

int wide_face(const World& world, const Light& light)
{
    Tasks tasks(1);
    LightMesh mesh;
    see_from_light(
        light_space(light, glm::dvec3(0)), world.position, world.scene->index, mesh, tasks);
    return mesh.wide_face;
}

TEST(GridLayers, ThatLieBehindAllSamplesShadowNothing)
{
    // All points are on the two layers nearest to the light, or on all.
    const Layers layers(24, 5, glm::vec3(0), 1);
    const World& world = layers.world.world;
    for (const bool near : {true, false}) {
        ShadowPoints all = layers.points(1500), asked;
        for (std::size_t k = 0; k < all.point.size(); ++k) {
            if (near && all.point[k].z > 0.2f) continue;
            asked.point.push_back(all.point[k]);
            asked.receiver.push_back(all.receiver[k]);
        }
        expect_plain_shadows(world, point_light({0.3, 0.2, -3}), asked);
        expect_plain_shadows(world, directional_light({0.1, -0.2, 1}), asked);
    }
}

TEST(GridLayers, AreSeenByOneWideFaceAcrossTheCubesEdges)
{
    const Layers layers(20, 3, glm::vec3(0), 1);
    const World& world = layers.world.world;
    const Light light = point_light({-2, 1.8, -2.2});
    ASSERT_GE(wide_face(world, light), 0);
    expect_plain_shadows(world, light, layers.points(1000));
}

TEST(GridLayers, ShadowPointsThatTheWideFaceDoesNotSee)
{
    // Points are given anywhere, also behind the light and beside all triangles.
    const Layers layers(20, 2, glm::vec3(0, 0, 1.5), 1);
    const World& world = layers.world.world;
    const Light light = point_light({0.4, 0, 0.9});
    ASSERT_EQ(wide_face(world, light), 4);
    std::mt19937 random{11};
    ShadowPoints asked;
    for (int k = 0; k < 1500; ++k) {
        const auto along = [&] { return uniform(random, -4, 4); };
        asked.point.push_back({along(), along(), along()});
        asked.receiver.push_back(kNoItem);
    }
    expect_plain_shadows(world, light, asked);
}

TEST(GridLayers, ThatAreSmallAndFarBesideTheAxisAreNotDecidedByTheirPlaces)
{
    // Places of samples and corners are off by up to a hundred: a face's roundings are far larger
    // than its box's 65,536th part.
    for (const float size : {1e-2f, 1e-3f, 1e-4f}) {
        const Layers layers(20, 3, glm::vec3(5, 4, 0), size);
        expect_plain_shadows(
            layers.world.world, point_light({0, 0, -2 - 3 * double(size)}), layers.points(800));
    }
}

} // namespace
} // namespace firsthit::test
