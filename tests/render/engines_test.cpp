// engines_test.cpp - the choice of the engine, and that all engines make the same picture.
#include "message_of.h"
#include "scene/model/borrow.h"
#include "scenes.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace firsthit::test {
namespace {

/// A world and its camera; skips the test where there is no OpenGL.
class Engines : public testing::Test {
  protected:
    void SetUp() override
    {
        try {
            Settings settings;
            settings.engine = Engine::gpu;
            show("builtin:torus", 0);
            render(settings);
        } catch (const DeviceError& error) {
            GTEST_SKIP() << error.what();
        }
    }

    void show(const std::string& name, double time_s, int size = 128)
    {
        scene_ = load_scene(name);
        pose(borrow(scene_), time_s, world_);
        view_.width = view_.height = size;
        view_.camera = world_.camera;
    }

    Film render(const Settings& settings)
    {
        Film film;
        renderer_.render(world_, view_, settings, film);
        return film;
    }

    /// The share of pixels whose colours differ by more than a hundredth.
    static double different(const Film& a, const Film& b)
    {
        EXPECT_EQ(a.color.value.size(), b.color.value.size());
        std::size_t count = 0;
        for (std::size_t k = 0; k < a.color.value.size(); k += 3) {
            float most = 0;
            for (std::size_t c = k; c < k + 3; ++c)
                most = std::max(most, std::abs(a.color.value[c] - b.color.value[c]));
            count += !(most < 0.01f);
        }
        return 3 * double(count) / double(a.color.value.size());
    }

    Scene scene_;
    World world_;
    View view_;
    Renderer renderer_{2};
};

constexpr Multisample kModes[] = {Multisample::none, Multisample::lazy3, Multisample::lazy5,
    Multisample::full3, Multisample::full5, Multisample::exact};

TEST_F(Engines, MakeTheSamePictureInEveryMode)
{
    for (const auto& [name, time] : {std::pair("builtin:torus", 0.0),
             std::pair("builtin:robots", 2.5), std::pair("builtin:wave?n=20000", 0.5)}) {
        show(name, time);
        for (const Shadows shadows : {Shadows::none, Shadows::map}) {
            Settings settings;
            settings.shadows = shadows;
            const Film expected = render(settings);
            for (const Engine engine : {Engine::hybrid, Engine::gpu})
                for (const Multisample mode : kModes)
                    for (const GpuPasses passes : {GpuPasses::single, GpuPasses::multi}) {
                        SCOPED_TRACE(std::string(name) + ", engine " + std::to_string(int(engine)) +
                                     ", mode " + std::to_string(int(mode)));
                        if (engine == Engine::hybrid && passes == GpuPasses::multi) continue;
                        settings.engine = engine;
                        settings.multisample = mode;
                        settings.opengl.passes = passes;
                        // At borders of shadows, points may fall on neighbouring texels.
                        EXPECT_LT(different(render(settings), expected),
                            shadows == Shadows::map ? 0.02 : 0.004);
                    }
        }
    }
}

TEST_F(Engines, HybridWithExactItemsIsTheCpuEngineBitForBit)
{
    for (const char* name : {"builtin:torus", "builtin:robots", "builtin:wave?n=20000"}) {
        SCOPED_TRACE(name);
        show(name, 1.5, 200);
        Settings settings;
        for (int k = 0; k < kAovCount; ++k) settings.aovs.push_back(Aov(k));
        settings.shadows = Shadows::exact;
        const Film expected = render(settings);
        settings.engine = Engine::hybrid;
        settings.multisample = Multisample::exact;
        const Film film = render(settings);
        EXPECT_EQ(film.color.value, expected.color.value);
        EXPECT_EQ(film.item, expected.item);
        for (int k = 0; k < kAovCount; ++k)
            EXPECT_EQ(film[Aov(k)].value, expected[Aov(k)].value) << aov_name(Aov(k));
    }
}

TEST_F(Engines, MakeTheSamePictureOfACalibratedCamera)
{
    show("builtin:robots", 2.5, 200);
    view_.camera.focal = glm::dvec2(250.3, 160.7);
    view_.camera.principal_point = glm::dvec2(81.37, 120.9);
    view_.camera.skew = 21.5;
    Settings settings;
    for (int k = 0; k < kAovCount; ++k) settings.aovs.push_back(Aov(k));
    settings.shadows = Shadows::exact;
    const Film exact = render(settings);
    settings.engine = Engine::hybrid;
    settings.multisample = Multisample::exact;
    const Film hybrid = render(settings);
    EXPECT_EQ(hybrid.color.value, exact.color.value);
    EXPECT_EQ(hybrid.item, exact.item);
    for (int k = 0; k < kAovCount; ++k)
        EXPECT_EQ(hybrid[Aov(k)].value, exact[Aov(k)].value) << aov_name(Aov(k));

    settings.shadows = Shadows::map;
    settings.engine = Engine::cpu;
    const Film expected = render(settings);
    settings.engine = Engine::gpu;
    const Film gpu = render(settings);
    EXPECT_EQ(gpu.item, expected.item);
    EXPECT_LT(different(gpu, expected), 0.02);
    settings.multisample = Multisample::lazy3;
    EXPECT_LT(different(render(settings), expected), 0.02);
}

TEST_F(Engines, GpuItemsAreExactWhereAsked)
{
    show("builtin:robots", 2.5, 300);
    Settings settings;
    settings.color = false;
    settings.aovs = {Aov::item};
    const Film expected = render(settings);
    settings.engine = Engine::gpu;
    settings.multisample = Multisample::exact;
    EXPECT_EQ(render(settings).item, expected.item);
}

TEST_F(Engines, ShowUnlitSurfacesAsTheyAre)
{
    const glm::vec3 color(0.25f, 0.5f, 1.5f);
    scene_ = scene_from_arrays({{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 1, 2}});
    scene_.materials[0].model = Unlit{.color = color};
    scene_.lights = {Light{.position = {0, 0, -5}}}; // behind
    pose(borrow(scene_), 0, world_);
    view_.width = view_.height = 64;
    view_.camera = framing_camera(world_);
    for (const Engine engine : {Engine::cpu, Engine::hybrid, Engine::gpu})
        for (const Shadows shadows : {Shadows::none, Shadows::map, Shadows::exact}) {
            if (engine == Engine::gpu && shadows == Shadows::exact) continue;
            Settings settings;
            settings.engine = engine;
            settings.shadows = shadows;
            settings.multisample = Multisample::exact;
            settings.aovs = {Aov::item};
            const Film film = render(settings);
            std::size_t seen = 0;
            for (std::size_t pixel = 0; pixel < film.item.size(); ++pixel) {
                const float* const found = &film.color.value[3 * pixel];
                if (film.item[pixel] == kNoItem) continue;
                ++seen;
                ASSERT_EQ(glm::vec3(found[0], found[1], found[2]), color)
                    << "engine " << int(engine) << ", shadows " << int(shadows);
            }
            EXPECT_GT(seen, 100u);
        }
}

TEST_F(Engines, ReportWhichEngineRanAndWhy)
{
    Settings settings;
    render(settings);
    EXPECT_EQ(renderer_.engine().engine, Engine::cpu);
    EXPECT_EQ(renderer_.engine().device, "");
    EXPECT_EQ(renderer_.engine().reason, "");
    settings.engine = Engine::hybrid;
    render(settings);
    EXPECT_EQ(renderer_.engine().engine, Engine::hybrid);
    EXPECT_NE(renderer_.engine().device.find("OpenGL 4."), std::string::npos);
    settings.engine = Engine::automatic;
    render(settings);
    EXPECT_TRUE(
        renderer_.engine().engine == Engine::cpu || renderer_.engine().engine == Engine::gpu);
    EXPECT_NE(renderer_.engine().reason, "");
    settings.shadows = Shadows::exact;
    render(settings);
    EXPECT_EQ(renderer_.engine().engine, Engine::cpu);
    EXPECT_EQ(renderer_.engine().reason, "exact shadows are made by the cpu engine");
}

TEST_F(Engines, UploadTheSceneOnceAndCountItsBytes)
{
    for (const Engine engine : {Engine::hybrid, Engine::gpu}) {
        for (const Multisample mode : {Multisample::lazy3, Multisample::exact}) {
            SCOPED_TRACE(std::to_string(int(engine)) + ", mode " + std::to_string(int(mode)));
            show("builtin:robots", 2.5);
            Settings settings;
            settings.engine = engine;
            settings.multisample = mode;
            Renderer renderer(2);
            Film film;
            renderer.render(world_, view_, settings, film);
            EXPECT_GT(
                renderer.stats().uploaded_bytes, scene_.position.size() * sizeof(glm::vec3) +
                                                     scene_.index.size() * sizeof(glm::uvec3));
            renderer.render(world_, view_, settings, film);
            EXPECT_EQ(renderer.stats().uploaded_bytes, 0u);
        }
    }
}

TEST_F(Engines, RefuseWhatTheyCannotDo)
{
    Settings settings;
    settings.engine = Engine::gpu;
    settings.shadows = Shadows::exact;
    EXPECT_EQ(message_of<ArgumentError>([&] { render(settings); }),
        "the gpu engine has no exact shadows: accepted are maps or none, or another engine");
    settings.engine = Engine::hybrid;
    settings.opengl.readback_chunks = 65;
    EXPECT_EQ(message_of<ArgumentError>([&] { render(settings); }),
        "65 readback chunks is out of range: 1 to 64");
}

TEST_F(Engines, HybridReadsBackTheSameSyncAndAsync)
{
    show("builtin:robots", 2.5, 256);
    Settings settings;
    settings.engine = Engine::hybrid;
    settings.opengl.readback = Readback::sync;
    const Film expected = render(settings);
    settings.opengl.readback = Readback::async;
    for (const int chunks : {1, 3, 8, 64}) {
        settings.opengl.readback_chunks = chunks;
        EXPECT_EQ(render(settings).color.value, expected.color.value) << chunks;
    }
}

} // namespace
} // namespace firsthit::test
