// endurance_test.cpp - ten thousand frames in one process do not use more and more memory.
#include "gl/device/objects.h"
#include "scene/model/borrow.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace firsthit {
namespace {

constexpr int kFrames = 10000, kDecided = 1000;

/// Memory that this process uses.
std::size_t resident_bytes()
{
    std::ifstream statm("/proc/self/statm");
    std::size_t size = 0, resident = 0;
    statm >> size >> resident;
    return resident * std::size_t(sysconf(_SC_PAGESIZE));
}

/// Settings of consecutive frames: all engines, modes and formats in turn.
Settings settings_of(int frame)
{
    Settings settings;
    settings.engine = frame % 2 ? Engine::gpu : Engine::hybrid;
    settings.multisample = Multisample(frame / 2 % 6);
    settings.shadows = frame / 12 % 2 ? Shadows::map : Shadows::none;
    settings.interleave = frame % 5 == 0 ? 2 : 1;
    settings.opengl.readback = frame % 3 ? Readback::async : Readback::sync;
    settings.opengl.passes = frame % 3 ? GpuPasses::single : GpuPasses::multi;
    return settings;
}

TEST(Endurance, TenThousandFramesTakeNoMemoryAndAreNeverBlank)
{
    const Scene scene = load_scene("builtin:torus");
    World world;
    pose(borrow(scene), 0, world);
    View view;
    view.width = view.height = 32;
    view.camera = framing_camera(world);
    Renderer renderer(1);
    Film film;
    std::size_t memory = 0;
    std::int64_t objects = 0;
    for (int frame = 0; frame < kFrames; ++frame) {
        try {
            renderer.render(world, view, settings_of(frame), film);
        } catch (const DeviceError& error) {
            if (frame == 0) GTEST_SKIP() << error.what();
            throw;
        }
        // The torus is brighter than the background at some pixel in the middle row.
        const auto row = film.color.value.begin() + 16 * 32 * 3;
        const auto [least, most] = std::minmax_element(row, row + 32 * 3);
        ASSERT_GT(*most - *least, 0.05f) << "frame " << frame;
        if (frame == kDecided) {
            memory = resident_bytes();
            objects = gl::gl_objects_alive();
        }
    }
    EXPECT_EQ(gl::gl_objects_alive(), objects);
    EXPECT_LT(double(resident_bytes()) - double(memory), 4e6);
}

} // namespace
} // namespace firsthit
