// fork_test.cpp - after fork(), a child process can destroy the objects that its parent made.
#include "scene/model/borrow.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <memory>
#include <thread>

namespace firsthit {
namespace {

constexpr int kSeconds = 20; // until a child counts as hanging; it needs milliseconds

/// Runs `work` in a child.
/// returns  the status of waitpid; that of SIGKILL if the child hung
int status_of_child(const std::function<bool()>& work)
{
    const pid_t child = fork();
    if (child == 0) _exit(work() ? 0 : 1);
    int status = -1;
    for (int tries = 0; tries < kSeconds * 100; ++tries) {
        if (waitpid(child, &status, WNOHANG) == child) return status;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
    return status;
}

class Fork : public testing::Test {
  protected:
    void SetUp() override
    {
        pose(borrow(scene), 0, world);
        view.width = view.height = 64;
        view.camera = framing_camera(world);
        settings.shadows = Shadows::map;
    }

    std::unique_ptr<Renderer> renderer_that_used(Engine engine)
    {
        auto renderer = std::make_unique<Renderer>(2);
        settings.engine = engine;
        renderer->render(world, view, settings, film);
        return renderer;
    }

    Scene scene = load_scene("builtin:torus");
    World world;
    View view;
    Settings settings;
    Film film;
};

TEST_F(Fork, TheChildMayDestroyARendererOfEveryEngine)
{
    for (const Engine engine : {Engine::cpu, Engine::hybrid, Engine::gpu}) {
        std::unique_ptr<Renderer> renderer;
        try {
            renderer = renderer_that_used(engine);
        } catch (const DeviceError& error) {
            GTEST_SKIP() << error.what();
        }
        const auto destroy = [&] {
            renderer.reset();
            return true;
        };
        EXPECT_EQ(status_of_child(destroy), 0) << "engine " << int(engine);
        // The parent's renderer still works.
        renderer->render(world, view, settings, film);
    }
}

TEST_F(Fork, TheChildMayDestroyOcclusionAndBaseline)
{
    auto occlusion = std::make_unique<Occlusion>(2);
    std::vector<std::uint8_t> occluded;
    occlusion->test(world, world.position, Light{.position = {5, 5, 5}}, occluded);
    EXPECT_EQ(status_of_child([&] {
        occlusion.reset();
        return true;
    }),
        0);
    std::unique_ptr<EmbreeBaseline> baseline;
    try {
        baseline = std::make_unique<EmbreeBaseline>(borrow(scene), BaselineUpdate::refit, 2);
    } catch (const DeviceError& error) {
        GTEST_SKIP() << error.what();
    }
    settings.shadows = Shadows::exact;
    baseline->render(view, settings, film);
    EXPECT_EQ(status_of_child([&] {
        baseline.reset();
        return true;
    }),
        0);
}

TEST_F(Fork, TheChildMayDestroyAnEngineComparer)
{
    auto comparer = std::make_unique<EngineComparer>(2);
    settings.engine = Engine::hybrid;
    try {
        comparer->compare(world, view, settings);
    } catch (const DeviceError& error) {
        GTEST_SKIP() << error.what();
    }
    EXPECT_EQ(status_of_child([&] {
        comparer.reset();
        return true;
    }),
        0);
}

TEST_F(Fork, TheChildRendersOnTheCpuAsItsParentDoes)
{
    const std::unique_ptr<Renderer> renderer = renderer_that_used(Engine::cpu);
    const auto same = [&] {
        Film again;
        renderer->render(world, view, settings, again);
        return again.color.value == film.color.value;
    };
    EXPECT_EQ(status_of_child(same), 0);
}

TEST_F(Fork, TheChildIsRefusedTheParentsOpenGl)
{
    std::unique_ptr<Renderer> renderer;
    try {
        renderer = renderer_that_used(Engine::hybrid);
    } catch (const DeviceError& error) {
        GTEST_SKIP() << error.what();
    }
    const auto refused = [&](Renderer& by) {
        try {
            by.render(world, view, settings, film);
        } catch (const DeviceError& error) {
            return std::string(error.what()).find("fork") != std::string::npos;
        }
        return false;
    };
    EXPECT_EQ(status_of_child([&] { return refused(*renderer) && refused(*renderer); }), 0);
    EXPECT_EQ(status_of_child([&] {
        Renderer another(1); // starts no threads: thread sanitizers forbid that in a child
        return refused(another);
    }),
        0);
}

} // namespace
} // namespace firsthit
