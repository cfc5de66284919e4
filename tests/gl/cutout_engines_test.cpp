// cutout_engines_test.cpp - cut-outs in the engines on OpenGL: exact, or refused.
#include "cpu/adversarial_scenes.h"
#include "cutouts.h"
#include "items.h"
#include "lights.h"
#include "message_of.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

namespace firsthit::test {
namespace {

/// A renderer, or the test is skipped as there is no OpenGL.
class CutoutEngines : public testing::Test {
  protected:
    void SetUp() override
    {
        TestWorld made;
        made.add({-1, -1, 2}, {1, -1, 2}, {1, 1, 2});
        try {
            render(made.finish(), Engine::hybrid, Multisample::none, Shadows::none);
        } catch (const DeviceError& error) {
            GTEST_SKIP() << error.what();
        }
    }

    Film render(const World& world, Engine engine, Multisample multisample, Shadows shadows)
    {
        Settings settings;
        settings.engine = engine;
        settings.multisample = multisample;
        settings.shadows = shadows;
        settings.interpolate = false;
        settings.aovs = {Aov::item};
        if (!world.lights.empty()) settings.aovs.push_back(Aov::lit);
        Film film;
        renderer.render(world, view, settings, film);
        return film;
    }

    Renderer renderer{1};
    const View view = straight_view(kSize, kSize, kSize);
};

TEST_F(CutoutEngines, DrawTheItemsOfTheCpu)
{
    for (const AdversarialScene& scene : adversarial_scenes()) {
        SCOPED_TRACE(scene.name);
        std::mt19937 random(11);
        TestWorld world;
        scene.fill(world, random);
        world.finish();
        make_cutouts(world, random, true);
        for (const Multisample multisample :
            {Multisample::none, Multisample::lazy3, Multisample::full5, Multisample::exact})
            EXPECT_EQ(render(world.world, Engine::hybrid, multisample, Shadows::none).item,
                render(world.world, Engine::cpu, multisample, Shadows::none).item)
                << int(multisample);
        // The gpu engine draws no blended surfaces.
        for (Material& material : world.scene->materials)
            if (material.alpha == AlphaMode::blend) material.alpha = AlphaMode::mask;
        const auto expected = items_of(world.world, view);
        for (const Multisample multisample : {Multisample::lazy3, Multisample::exact})
            EXPECT_EQ(render(world.world, Engine::gpu, multisample, Shadows::none).item, expected)
                << int(multisample);
    }
}

TEST_F(CutoutEngines, HaveTheCpusLayersOrNone)
{
    for (const std::size_t number : {0, 3}) {
        std::mt19937 random(12);
        TestWorld world;
        adversarial_scenes()[number].fill(world, random);
        world.finish();
        make_cutouts(world, random, true);
        for (Material& material : world.scene->materials) material.alpha = AlphaMode::blend;
        EXPECT_EQ(
            render(world.world, Engine::hybrid, Multisample::exact, Shadows::none).color.value,
            render(world.world, Engine::cpu, Multisample::exact, Shadows::none).color.value);
        EXPECT_NE(message_of<ArgumentError>([&] {
            render(world.world, Engine::gpu, Multisample::exact, Shadows::none);
        }).find("blend"),
            std::string::npos);
    }
}

TEST_F(CutoutEngines, HaveTheCpusShadowsOrNone)
{
    TestWorld world;
    world.add({-3, -3, 4}, {3, -3, 4}, {3, 3, 4});
    world.add({-3, -3, 4}, {3, 3, 4}, {-3, 3, 4});
    world.add({-1, -1, 2}, {1, -1, 2}, {1, 1, 2});
    world.finish();
    std::mt19937 random(2);
    make_cutouts(world, random, false);
    Scene& scene = *world.scene;
    scene.instances.assign(3, scene.instances[0]);
    scene.materials.assign(2, Material{});
    scene.materials[1].alpha = AlphaMode::mask;
    scene.materials[1].opacity_texture = {2, 0};
    for (std::uint32_t t = 0; t < 3; ++t) {
        scene.owner[t] = t;
        scene.instances[t].first_triangle = t;
        scene.instances[t].triangle_count = 1;
        scene.instances[t].material = t == 2;
    }
    world.world.lights = scene.lights = {point_light({0.3, 0.2, -1})};
    for (const Shadows shadows : {Shadows::map, Shadows::exact})
        EXPECT_EQ(render(world.world, Engine::hybrid, Multisample::lazy3, shadows)[Aov::lit].value,
            render(world.world, Engine::cpu, Multisample::lazy3, shadows)[Aov::lit].value);
    EXPECT_NE(message_of<ArgumentError>([&] {
        render(world.world, Engine::gpu, Multisample::exact, Shadows::map);
    }).find("cut-outs"),
        std::string::npos);
    render(world.world, Engine::automatic, Multisample::lazy3, Shadows::map);
    EXPECT_EQ(renderer.engine().engine, Engine::cpu);
}

} // namespace
} // namespace firsthit::test
