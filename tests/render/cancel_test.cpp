// cancel_test.cpp - a cancelled frame leaves the renderer as if it had never begun.
#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace firsthit {
namespace {

/// The ways in which a frame can be made.
struct Case {
    std::string name;
    Engine engine;
    Shadows shadows;
    int samples = 1;
    int interleave = 1;
    Readback readback = Readback::async;
    Multisample multisample = Multisample::lazy3;
};

const std::vector<Case>& cases()
{
    static const std::vector<Case> all{
        {"cpu_none", Engine::cpu, Shadows::none},
        {"cpu_map", Engine::cpu, Shadows::map},
        {"cpu_exact", Engine::cpu, Shadows::exact},
        {"cpu_exact_samples", Engine::cpu, Shadows::exact, 2},
        {"cpu_map_interleaved", Engine::cpu, Shadows::map, 1, 4},
        {"hybrid_none", Engine::hybrid, Shadows::none},
        {"hybrid_map", Engine::hybrid, Shadows::map},
        {"hybrid_map_sync", Engine::hybrid, Shadows::map, 1, 1, Readback::sync},
        {"hybrid_exact", Engine::hybrid, Shadows::exact},
        {"hybrid_exact_items", Engine::hybrid, Shadows::map, 1, 1, Readback::async,
            Multisample::exact},
        {"gpu_none", Engine::gpu, Shadows::none},
        {"gpu_map", Engine::gpu, Shadows::map},
        {"gpu_map_samples", Engine::gpu, Shadows::map, 2},
        {"gpu_exact_items", Engine::gpu, Shadows::map, 1, 1, Readback::async, Multisample::exact},
    };
    return all;
}

/// The robots between two lamps and under the sun.
std::shared_ptr<const Scene> robots()
{
    Scene scene = load_scene("builtin:robots");
    Light lamp, other, sun;
    lamp.position = {1, 6, 2};
    other.position = {-3, 5, 1};
    sun.kind = Light::Kind::directional;
    sun.direction = {-0.4, -1, 0.3};
    scene.lights = {lamp, other, sun};
    return std::make_shared<const Scene>(std::move(scene));
}

class Cancel : public testing::TestWithParam<std::size_t> {
  protected:
    void SetUp() override
    {
        const Case& of = cases()[GetParam()];
        settings_.engine = of.engine;
        settings_.shadows = of.shadows;
        settings_.samples = of.samples;
        settings_.interleave = of.interleave;
        settings_.multisample = of.multisample;
        settings_.opengl.readback = of.readback;
        settings_.tile_size = 32;
        settings_.aovs = {Aov::item, Aov::depth, Aov::lit};
        pose(scene_, 1.5, world_);
        view_.width = 200;
        view_.height = 150;
        view_.camera = world_.camera;
        try {
            expected_ = fresh(world_);
        } catch (const DeviceError& error) {
            GTEST_SKIP() << error.what();
        }
    }

    Film fresh(const World& world) const
    {
        Film film;
        Renderer(2).render(world, view_, settings_, film);
        return film;
    }

    static void expect_equal(const Film& film, const Film& expected)
    {
        EXPECT_EQ(film.width, expected.width);
        EXPECT_EQ(film.height, expected.height);
        EXPECT_TRUE(film.color.value == expected.color.value);
        EXPECT_TRUE(film.item == expected.item);
        for (int a = 0; a < kAovCount; ++a)
            EXPECT_TRUE(film[Aov(a)].value == expected[Aov(a)].value) << aov_name(Aov(a));
    }

    /// Every plane has the size that width and height say.
    void expect_whole(const Film& film) const
    {
        const std::size_t pixels = std::size_t(film.width) * std::size_t(film.height);
        EXPECT_EQ(pixels, std::size_t(view_.width * view_.height));
        EXPECT_EQ(film.color.value.size(), 3 * pixels);
        EXPECT_EQ(film.item.size(), pixels);
        EXPECT_EQ(film[Aov::depth].value.size(), pixels);
        EXPECT_EQ(film[Aov::lit].value.size(), world_.lights.size() * pixels);
        EXPECT_TRUE(film[Aov::normal].empty());
    }

    std::shared_ptr<const Scene> scene_ = robots();
    World world_;
    View view_;
    Settings settings_;
    Film expected_;
    Renderer renderer_{2};
};

TEST_P(Cancel, ProgressRisesFromZeroToOneOnTheCallersThread)
{
    std::vector<double> shares;
    const std::thread::id caller = std::this_thread::get_id();
    bool elsewhere = false;
    FrameControl control;
    control.progress = [&](double share) {
        shares.push_back(share);
        elsewhere |= std::this_thread::get_id() != caller;
    };
    for (const int threads : {1, 3}) {
        shares.clear();
        Film film;
        Renderer(threads).render(world_, view_, settings_, film, control);
        expect_equal(film, expected_);
        EXPECT_FALSE(elsewhere);
        // If other threads do all the work, nothing is reported between begin and end.
        ASSERT_GE(shares.size(), threads == 1 ? 5u : 2u);
        EXPECT_EQ(shares.front(), 0);
        EXPECT_EQ(shares.back(), 1);
        for (std::size_t k = 1; k < shares.size(); ++k) EXPECT_LT(shares[k - 1], shares[k]);
    }
}

TEST_P(Cancel, BeforeTheFrameLeavesTheFilmAsItWas)
{
    std::stop_source source;
    source.request_stop();
    int calls = 0;
    Film film;
    EXPECT_THROW(renderer_.render(world_, view_, settings_, film,
                     {source.get_token(), [&](double) { ++calls; }}),
        Cancelled);
    EXPECT_EQ(calls, 0);
    EXPECT_EQ(film.width, 0);
    EXPECT_TRUE(film.color.empty());
    renderer_.render(world_, view_, settings_, film);
    expect_equal(film, expected_);
}

TEST_P(Cancel, AtAnyShareTheNextFrameIsAFreshRenderers)
{
    World later;
    pose(scene_, 2.25, later);
    const Film expected_later = fresh(later);
    Film film;
    for (const bool warm : {false, true}) {
        for (const double at : {0.0, 0.05, 0.2, 0.4, 0.6, 0.8, 0.95}) {
            Renderer renderer(2);
            if (warm) renderer.render(world_, view_, settings_, film);
            std::stop_source source;
            double last = -1;
            bool stopped = false, after = false;
            const auto progress = [&](double share) {
                after |= stopped;
                last = share;
                if (share < at) return;
                stopped = true;
                source.request_stop();
            };
            // A different world than in the next frame, so that anything that is left would show.
            bool cancelled = false;
            try {
                renderer.render(later, view_, settings_, film, {source.get_token(), progress});
            } catch (const Cancelled&) {
                cancelled = true;
            }
            // If there are few reports, the first one that is late enough may be the last.
            EXPECT_EQ(cancelled, last < 1) << at;
            EXPECT_FALSE(after) << at;
            if (at <= 0) {
                EXPECT_TRUE(cancelled);
            }
            expect_whole(film);
            renderer.render(world_, view_, settings_, film);
            expect_equal(film, expected_);
            renderer.render(later, view_, settings_, film);
            expect_equal(film, expected_later);
        }
    }
}

TEST_P(Cancel, AgainAndAgainCountsOnlyTheFrameThatIsDone)
{
    Film film;
    Renderer fresh_one(2);
    fresh_one.render(world_, view_, settings_, film);
    const Stats expected = fresh_one.stats();
    for (int round = 0; round < 5; ++round) {
        std::stop_source source;
        const auto stop = [&](double share) {
            if (share >= 0.1 * round && share < 1) source.request_stop();
        };
        try {
            renderer_.render(world_, view_, settings_, film, {source.get_token(), stop});
            EXPECT_FALSE(source.stop_requested());
        } catch (const Cancelled&) {
            EXPECT_TRUE(source.stop_requested());
        }
    }
    renderer_.render(world_, view_, settings_, film);
    expect_equal(film, expected_);
    EXPECT_EQ(renderer_.stats().hits, expected.hits);
    EXPECT_EQ(renderer_.stats().missed, expected.missed);
    EXPECT_EQ(renderer_.stats().interpolated, expected.interpolated);
    EXPECT_EQ(renderer_.stats().uncertain_samples, expected.uncertain_samples);
    EXPECT_EQ(renderer_.stats().shadow_points, expected.shadow_points);
}

TEST_P(Cancel, FromAnotherThread)
{
    Film film;
    int cancelled = 0;
    for (int round = 0; round < 8; ++round) {
        std::stop_source source;
        std::atomic<bool> begun{false};
        std::thread other([&] {
            while (!begun) std::this_thread::yield();
            std::this_thread::sleep_for(std::chrono::microseconds(400 * round));
            source.request_stop();
        });
        const auto progress = [&](double) {
            begun = true;
            while (round == 0 && !source.stop_requested()) std::this_thread::yield();
        };
        try {
            renderer_.render(world_, view_, settings_, film, {source.get_token(), progress});
            expect_equal(film, expected_); // it was faster
        } catch (const Cancelled&) {
            ++cancelled;
            expect_whole(film);
        }
        other.join();
    }
    EXPECT_GT(cancelled, 0);
    renderer_.render(world_, view_, settings_, film);
    expect_equal(film, expected_);
}

TEST_P(Cancel, AfterTheFrameIsTooLate)
{
    std::stop_source source;
    Film film;
    const auto at_last = [&](double share) {
        if (share == 1) source.request_stop();
    };
    renderer_.render(world_, view_, settings_, film, {source.get_token(), at_last});
    EXPECT_TRUE(source.stop_requested());
    expect_equal(film, expected_);
}

TEST_P(Cancel, WhatProgressThrowsComesOut)
{
    Film film;
    const auto fails = [](double share) {
        if (share > 0) throw std::string("enough");
    };
    EXPECT_THROW(renderer_.render(world_, view_, settings_, film, {{}, fails}), std::string);
    renderer_.render(world_, view_, settings_, film);
    expect_equal(film, expected_);
}

INSTANTIATE_TEST_SUITE_P(Engines, Cancel, testing::Range(std::size_t(0), cases().size()),
    [](const auto& of) { return cases()[of.param].name; });

TEST(SharedScene, LivesAsLongAsTheWorld)
{
    World world;
    std::weak_ptr<const Scene> watched;
    {
        const auto scene = std::make_shared<const Scene>(load_scene("builtin:torus"));
        watched = scene;
        pose(scene, 0, world);
    }
    EXPECT_FALSE(watched.expired());
    View view;
    view.width = view.height = 16;
    view.camera = framing_camera(world);
    Film film;
    Renderer renderer(1);
    renderer.render(world, view, {}, film);
    EXPECT_EQ(film.color.value.size(), 16u * 16 * 3);
    pose(load_scene("builtin:torus"), 0, world); // moved in, nobody else has it
    EXPECT_TRUE(watched.expired());
    EXPECT_EQ(world.scene.use_count(), 1);
    EXPECT_THROW(pose(nullptr, 0, world), ArgumentError);
}

TEST(SharedScene, ARendererKeepsNoneThatItWasLent)
{
    const auto scene = std::make_shared<const Scene>(load_scene("builtin:torus"));
    View view;
    view.width = view.height = 16;
    World world;
    pose(scene, 0, world);
    view.camera = framing_camera(world);
    world = {};
    Renderer renderer(1);
    Film film;
    renderer.render(*scene, 0, view, {}, film);
    EXPECT_EQ(scene.use_count(), 1);
    renderer.pose(scene, 0, world);
    EXPECT_EQ(scene.use_count(), 2);
}

} // namespace
} // namespace firsthit
