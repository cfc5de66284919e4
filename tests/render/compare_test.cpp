// compare_test.cpp - compares items and shadows of whole scenes with both oracles.
#include "scene/model/borrow.h"
#include "scenes.h"
#include "test_data.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

namespace firsthit::test {
namespace {

void expect_right(const Scene& scene, double time_s, Oracle oracle, int size)
{
    World world;
    pose(borrow(scene), time_s, world);
    View view;
    view.width = view.height = size;
    view.camera = world.camera;
    const Comparison c = compare(world, view, oracle, 2);
    EXPECT_EQ(c.ours_wrong, 0u) << scene.name << " at " << time_s;
    EXPECT_EQ(c.pixels, std::uint64_t(size) * std::uint64_t(size));
    EXPECT_EQ(c.pixels, c.agree + c.ties + c.ours_wrong + c.theirs_wrong);
    const LitComparison lit = compare_lit(world, view, oracle, 2);
    EXPECT_EQ(lit.ours_wrong, 0u) << scene.name << " at " << time_s;
    EXPECT_EQ(lit.pixels, lit.agree + lit.ours_wrong + lit.theirs_wrong);
    EXPECT_GT(double(lit.agree), 0.999 * double(lit.pixels));
    EXPECT_GT(lit.pixels, c.pixels / 20);
    if (oracle == Oracle::brute) {
        EXPECT_EQ(c.agree, c.pixels);
        EXPECT_EQ(lit.agree, lit.pixels);
    } else {
        EXPECT_GT(double(c.agree + c.ties), 0.999 * double(c.pixels));
    }
}

TEST(Compare, TorusEqualsBruteForceAndEmbree)
{
    const Scene scene = load_scene("builtin:torus");
    expect_right(scene, 0, Oracle::brute, 256);
    expect_right(scene, 0, Oracle::embree, 256);
}

TEST(Compare, RobotsEqualBruteForceAndEmbree)
{
    const Scene scene = load_scene("builtin:robots");
    for (const double time_s : {0.0, 2.5, 7.1}) {
        expect_right(scene, time_s, Oracle::brute, 192);
        expect_right(scene, time_s, Oracle::embree, 192);
    }
}

TEST(Compare, WaveEqualsBruteForceAndEmbree)
{
    const Scene scene = load_scene("builtin:wave?n=50000");
    expect_right(scene, 0.3, Oracle::brute, 160);
    expect_right(scene, 0.3, Oracle::embree, 160);
}

TEST(Compare, BartRobotsEqualEmbree)
{
    const auto path = test_data("bart/scene_robot/aff/Robot.aff");
    if (!path) GTEST_SKIP() << "FIRSTHIT_TEST_DATA has no bart/scene_robot/aff/Robot.aff";
    const Scene scene = load_scene(path->string());
    for (const double time_s : {5.0, 10.0, 20.0, 30.0, 45.0})
        expect_right(scene, time_s, Oracle::embree, 192);
    expect_right(scene, 10, Oracle::brute, 128);
}

TEST(Compare, CountsTiesOfCoplanarSurfaces)
{
    // The same square twice, split along different diagonals: Embree may name either.
    TestWorld world;
    world.add({-1, -1, 2}, {1, -1, 2}, {1, 1, 2});
    world.add({-1, -1, 2}, {1, 1, 2}, {-1, 1, 2});
    world.add({-1, -1, 2}, {1, -1, 2}, {-1, 1, 2});
    world.add({1, -1, 2}, {1, 1, 2}, {-1, 1, 2});
    world.finish();
    const View view = straight_view(64, 64, 64);
    for (const Oracle oracle : {Oracle::brute, Oracle::embree}) {
        const Comparison c = compare(world.world, view, oracle, 1);
        EXPECT_EQ(c.ours_wrong, 0u);
        EXPECT_EQ(c.theirs_wrong, 0u);
    }
}

} // namespace
} // namespace firsthit::test
