// sky_engines_test.cpp - the light of the sky in the engines on OpenGL.
#include "sky_scene.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace firsthit::test {
namespace {

/// A scene under a sky, or the test is skipped as there is no OpenGL.
class SkyEngines : public testing::Test {
  protected:
    void SetUp() override
    {
        try {
            Settings settings;
            settings.engine = Engine::hybrid;
            scene.render(settings, 1);
        } catch (const DeviceError& error) {
            GTEST_SKIP() << error.what();
        }
    }

    SkyScene scene{3};
};

TEST_F(SkyEngines, HybridMakesThePictureOfTheCpu)
{
    Settings settings = sky_settings(11);
    const Film cpu = scene.render(settings, 2);
    settings.engine = Engine::hybrid;
    settings.multisample = Multisample::exact;
    EXPECT_EQ(scene.render(settings, 2).color.value, cpu.color.value);
}

TEST_F(SkyEngines, NothingHidesTheSkyFromTheGpu)
{
    Settings settings = sky_settings(1);
    settings.engine = Engine::gpu;
    settings.aovs = {Aov::item, Aov::normal};
    const Film film = scene.render(settings, 1);
    const glm::vec3 up(glm::normalize(scene.view.camera.up));
    std::size_t hits = 0;
    for (std::size_t pixel = 0; pixel < film.item.size(); ++pixel) {
        if (film.item[pixel] == kNoItem) continue;
        const float n_up = glm::dot(at(film[Aov::normal], pixel), up);
        const glm::vec3 light =
            kSkyBlue * (0.5f + 0.5f * n_up) + glm::vec3(0.125f) * (0.5f - 0.5f * n_up);
        const glm::vec3 expected = glm::vec3(1, 0.75f, 0.5f) * light;
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(at(film.color, pixel)[c], expected[c], 1e-5f) << pixel;
        ++hits;
    }
    EXPECT_GT(hits, 1000u);
}

} // namespace
} // namespace firsthit::test
