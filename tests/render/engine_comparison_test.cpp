// engine_comparison_test.cpp - comparing the OpenGL engines with the cpu engine.
#include "message_of.h"
#include "scene/model/borrow.h"
#include "scenes.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace firsthit::test {
namespace {

TEST(EngineComparison, IsInfinitelyGoodWherePicturesAreEqual)
{
    EngineComparison equal;
    equal.pixels = 4;
    EXPECT_EQ(equal.psnr_db(), std::numeric_limits<double>::infinity());
    EXPECT_FALSE(equal.psnr_same_items_db());
}

TEST(EngineComparison, MeasuresDecibelsOfTheMeanSquare)
{
    EngineComparison comparison;
    comparison.pixels = 100;
    comparison.square_sum = 0.3; // 0.001 a value
    comparison.square_sum_same_items = 3e-4;
    EXPECT_NEAR(comparison.psnr_db(), 30, 1e-9);
    EXPECT_NEAR(*comparison.psnr_same_items_db(), 60, 1e-9);
}

TEST(EngineComparison, AddsFrames)
{
    EngineComparison a;
    a.pixels = 10, a.missed = 1, a.wrong = 2, a.ties = 3, a.interpolated = 4, a.square_sum = 5;
    a.largest_difference = 0.5;
    a.square_sum_same_items = 6;
    const EngineComparison twice = EngineComparison{} + a + a;
    EXPECT_EQ(twice.pixels, 20u);
    EXPECT_EQ(twice.missed, 2u);
    EXPECT_EQ(twice.wrong, 4u);
    EXPECT_EQ(twice.ties, 6u);
    EXPECT_EQ(twice.interpolated, 8u);
    EXPECT_EQ(twice.square_sum, 10);
    EXPECT_EQ(twice.largest_difference, 0.5);
    EXPECT_EQ(twice.square_sum_same_items, 12);
    a.square_sum_same_items.reset();
    EXPECT_FALSE((twice + a).square_sum_same_items);
}

/// Skipped if there is no OpenGL.
class EngineComparing : public testing::Test {
  protected:
    void SetUp() override
    {
        try {
            load("builtin:torus", 0, 16);
            compare(Engine::hybrid, Multisample::none);
        } catch (const DeviceError& error) {
            GTEST_SKIP() << error.what();
        }
    }

    void load(const std::string& name, double time_s, int size)
    {
        scene = load_scene(name);
        pose(borrow(scene), time_s, world);
        view.width = view.height = size;
        view.camera = world.camera;
    }

    EngineComparison compare(Engine engine, Multisample multisample)
    {
        settings.engine = engine;
        settings.multisample = multisample;
        return comparer.compare(world, view, settings);
    }

    Scene scene;
    World world;
    View view;
    Settings settings;
    EngineComparer comparer{2};
};

constexpr Engine kEngines[] = {Engine::hybrid, Engine::gpu};

TEST_F(EngineComparing, FindsFewMissesWithoutMultisampling)
{
    for (const char* name : {"builtin:torus", "builtin:robots"}) {
        load(name, 2.5, 256);
        for (const Engine engine : kEngines) {
            const EngineComparison c = compare(engine, Multisample::none);
            EXPECT_EQ(c.pixels, 65536u);
            EXPECT_LE(double(c.missed + c.wrong), 0.003 * double(c.pixels))
                << name << " " << int(engine);
            EXPECT_GT(c.psnr_db(), 35) << name << " " << int(engine);
        }
    }
}

TEST_F(EngineComparing, FindsFewerMissesWithMultisampling)
{
    load("builtin:robots", 2.5, 256);
    for (const Engine engine : kEngines) {
        const std::uint64_t missed = compare(engine, Multisample::none).missed;
        EXPECT_LT(compare(engine, Multisample::lazy3).missed, missed) << int(engine);
    }
}

TEST_F(EngineComparing, FindsNothingWrongWithExactItems)
{
    for (const char* name : {"builtin:torus", "builtin:robots"}) {
        load(name, 2.5, 256);
        for (const Engine engine : kEngines) {
            const EngineComparison c = compare(engine, Multisample::exact);
            EXPECT_EQ(c.missed + c.wrong + c.ties + c.interpolated, 0u)
                << name << " " << int(engine);
        }
    }
}

TEST_F(EngineComparing, FindsTheHybridEnginesExactPictureEqual)
{
    load("builtin:robots", 2.5, 256);
    settings.shadows = Shadows::exact;
    const EngineComparison c = compare(Engine::hybrid, Multisample::exact);
    EXPECT_TRUE(std::isinf(c.psnr_db())) << c.psnr_db();
    EXPECT_EQ(c.largest_difference, 0);
}

TEST_F(EngineComparing, FindsTheShadingOfTheGpuEngineEqualToTheEye)
{
    load("builtin:torus", 0, 256);
    EXPECT_GE(compare(Engine::gpu, Multisample::none).psnr_same_items_db().value_or(0), 60);
    load("builtin:robots", 2.5, 256); // textured
    EXPECT_GE(compare(Engine::gpu, Multisample::none).psnr_same_items_db().value_or(0), 45);
    settings.shadows = Shadows::none;
    settings.interleave = 4;
    EXPECT_GE(compare(Engine::gpu, Multisample::none).psnr_same_items_db().value_or(0), 45);
}

TEST_F(EngineComparing, LendsTheMapsOfLightsThatReachNothing)
{
    // A floor under a roof, in a part of few triangles.
    scene = scene_from_arrays({{-50, 0, -50}, {50, 0, -50}, {50, 0, 50}, {-50, 0, 50},
                                  {-60, 4, -60}, {60, 4, -60}, {60, 4, 60}, {-60, 4, 60}},
        {{0, 2, 1}, {0, 3, 2}, {4, 6, 5}, {4, 7, 6}});
    Light light;
    light.position = {0, 30, 0};
    scene.lights = {light};
    pose(borrow(scene), 0, world);
    view = {};
    view.width = view.height = 64;
    view.camera.eye = {0, 2, 0};
    view.camera.direction = {0.3, -1, 0.2};
    view.camera.up = {0, 0, 1};
    settings.shadows = Shadows::map;
    EXPECT_GE(compare(Engine::gpu, Multisample::none).psnr_same_items_db().value_or(0), 60);
}

TEST_F(EngineComparing, LendsItemsToTheGpuEngineAlone)
{
    EXPECT_FALSE(compare(Engine::hybrid, Multisample::none).psnr_same_items_db());
    settings.samples = 2;
    EXPECT_FALSE(compare(Engine::gpu, Multisample::none).psnr_same_items_db());
}

TEST_F(EngineComparing, CountsEveryItemThatDiffers)
{
    load("builtin:robots", 2.5, 256);
    for (const Engine engine : kEngines) {
        const EngineComparison c = compare(engine, Multisample::none);
        const Film &ours = comparer.engine_film(), &cpu = comparer.cpu_film();
        std::uint64_t different = 0;
        for (std::size_t k = 0; k < cpu.item.size(); ++k) different += ours.item[k] != cpu.item[k];
        EXPECT_EQ(c.missed + c.wrong + c.ties, different) << int(engine);
        EXPECT_GT(different, 0u) << int(engine);
    }
}

TEST_F(EngineComparing, CountsTiesApart)
{
    // Each triangle twice, starting at different corners: rounding may make the second one nearer.
    TestWorld twice;
    for (int k = 0; k < 16; ++k) {
        const auto x = float(k % 4), y = float(k / 4);
        const glm::vec3 a{x - 1.9f, y - 1.9f, 3.1f}, b{x - 1.1f, y - 1.8f, 4.3f + 0.1f * x},
            c{x - 1.5f, y - 1.2f, 5.7f - 0.1f * y};
        twice.add(a, b, c);
        twice.add(b, c, a);
    }
    view = straight_view(256, 256, 150);
    settings.engine = Engine::gpu;
    settings.multisample = Multisample::full3;
    const EngineComparison c = comparer.compare(twice.finish(), view, settings);
    EXPECT_GT(c.ties, 100u);
    EXPECT_LT(c.wrong + c.missed, 10u); // at edges
}

TEST_F(EngineComparing, CountsWhatIsInterpolated)
{
    load("builtin:robots", 2.5, 256);
    for (const Engine engine : kEngines) {
        settings.interpolate = true;
        // Holes count as missed if the cpu engine sees a triangle there.
        const EngineComparison filled = compare(engine, Multisample::none);
        EXPECT_GE(filled.interpolated, filled.missed) << int(engine);
        EXPECT_GT(filled.interpolated, 0u) << int(engine);
        settings.interpolate = false;
        const EngineComparison open = compare(engine, Multisample::none);
        EXPECT_EQ(open.interpolated, 0u) << int(engine);
        EXPECT_EQ(open.missed, filled.missed) << int(engine);
        EXPECT_LT(open.psnr_db(), filled.psnr_db()) << int(engine);
    }
}

TEST_F(EngineComparing, GoesOnWithAnotherSceneAndEngine)
{
    load("builtin:robots", 2.5, 100);
    compare(Engine::gpu, Multisample::lazy3);
    load("builtin:torus", 0, 64);
    compare(Engine::hybrid, Multisample::exact);
    view.region = {.x = 7, .y = 9, .width = 31, .height = 44};
    const EngineComparison kept = compare(Engine::gpu, Multisample::none);
    const EngineComparison fresh = compare_engines(world, view, settings, 1);
    EXPECT_EQ(kept.pixels, 31u * 44u);
    EXPECT_EQ(kept.missed, fresh.missed);
    EXPECT_EQ(kept.square_sum, fresh.square_sum);
    EXPECT_EQ(kept.square_sum_same_items, fresh.square_sum_same_items);
}

TEST_F(EngineComparing, NamesTheDevice)
{
    EXPECT_NE(comparer.device().find("OpenGL"), std::string::npos) << comparer.device();
}

TEST(EngineComparer, RefusesWhatCannotBeCompared)
{
    const Scene scene = load_scene("builtin:torus");
    World world;
    pose(borrow(scene), 0, world);
    Settings settings;
    EXPECT_EQ(message_of<ArgumentError>([&] { compare_engines(world, {}, settings); }),
        "only the hybrid and the gpu engine are compared with the cpu engine");
    settings.engine = Engine::gpu;
    settings.shadows = Shadows::exact;
    EXPECT_THROW(compare_engines(world, {}, settings), ArgumentError);
    settings.shadows = Shadows::map;
    View view;
    view.width = 0;
    EXPECT_THROW(compare_engines(world, view, settings), ArgumentError);
}

} // namespace
} // namespace firsthit::test
