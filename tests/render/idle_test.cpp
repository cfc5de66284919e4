// idle_test.cpp - idle threads sleep.
#include "scene/model/borrow.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <thread>

namespace firsthit {
namespace {

/// Processor time of all threads of this process.
double processor_seconds()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

double processor_share(std::chrono::milliseconds during)
{
    const double before = processor_seconds();
    std::this_thread::sleep_for(during);
    return (processor_seconds() - before) / std::chrono::duration<double>(during).count();
}

TEST(Idle, RenderersUseNoProcessor)
{
    const Scene scene = load_scene("builtin:torus");
    World world;
    pose(borrow(scene), 0, world);
    View view;
    view.width = view.height = 256;
    view.camera = framing_camera(world);
    Renderer renderer(4);
    for (const Engine engine : {Engine::cpu, Engine::hybrid}) {
        Settings settings;
        settings.engine = engine;
        Film film;
        try {
            renderer.render(world, view, settings, film);
        } catch (const DeviceError& error) {
            GTEST_SKIP() << error.what();
        }
        // Helpers stay awake for 150 us after a frame.
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        EXPECT_LT(processor_share(std::chrono::milliseconds(1000)), 0.05)
            << "engine " << int(engine);
    }
}

} // namespace
} // namespace firsthit
