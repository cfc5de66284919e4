// frame_allocation_test.cpp - frames of the same size allocate nothing.
#include "allocations.h"
#include "scene/model/borrow.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace firsthit {
namespace {

/// Allocations of frames 3 to 12, each at another time.
std::size_t allocations_after_two_frames(const Scene& scene, int threads, const Settings& settings)
{
    World world;
    pose(borrow(scene), 0, world);
    View view;
    view.width = view.height = 320;
    view.camera = framing_camera(world);
    Renderer renderer(threads);
    Film film;
    const auto frame = [&](int number) {
        renderer.render(scene, 0.7 * number, view, settings, film);
    };
    frame(0);
    frame(1);
    const std::size_t before = allocations();
    for (int number = 2; number < 12; ++number) frame(number);
    return allocations() - before;
}

std::size_t allocations_after_two_frames(
    const std::string& name, int threads, const Settings& settings)
{
    return allocations_after_two_frames(load_scene(name), threads, settings);
}

/// A lamp among the robots, and the sun.
std::vector<Light> two_lights()
{
    Light lamp, sun;
    lamp.position = {1, 6, 2};
    sun.kind = Light::Kind::directional;
    sun.direction = {-0.4, -1, 0.3};
    return {lamp, sun};
}

TEST(FrameAllocation, IsNoneAfterTheSecondFrame)
{
    Settings settings;
    settings.aovs = {Aov::item, Aov::depth, Aov::normal};
    for (const int threads : {1, 2}) {
        EXPECT_EQ(allocations_after_two_frames("builtin:robots", threads, settings), 0u);
        EXPECT_EQ(allocations_after_two_frames("builtin:wave?n=20000", threads, settings), 0u);
    }
}

TEST(FrameAllocation, IsNoneWithSupersampling)
{
    Settings settings;
    settings.samples = 3;
    settings.aovs = {Aov::item};
    EXPECT_EQ(allocations_after_two_frames("builtin:robots", 2, settings), 0u);
}

TEST(FrameAllocation, IsNoneWhereFramesAreInterleaved)
{
    Settings settings;
    settings.interleave = 4;
    settings.aovs = {Aov::item};
    EXPECT_EQ(allocations_after_two_frames("builtin:robots", 2, settings), 0u);
}

TEST(FrameAllocation, IsNoneWithTheShadowsOfTwoLights)
{
    for (const char* name : {"builtin:robots", "builtin:wave?n=20000"}) {
        Scene scene = load_scene(name);
        scene.lights = two_lights();
        for (const Shadows technique : {Shadows::map, Shadows::exact}) {
            Settings settings;
            settings.shadows = technique;
            settings.aovs = {Aov::lit};
            for (const int threads : {1, 2})
                EXPECT_EQ(allocations_after_two_frames(scene, threads, settings), 0u)
                    << name << (technique == Shadows::map ? ", map, " : ", exact, ") << threads;
        }
    }
}

} // namespace
} // namespace firsthit
