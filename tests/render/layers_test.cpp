// layers_test.cpp - blended surfaces against all hits of each ray, sorted.
#include "cpu/adversarial_scenes.h"
#include "cutouts.h"
#include "exact/opacity.h"
#include "items.h"
#include "lights.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace firsthit::test {
namespace {

Film colors(const World& world, const View& view, int samples = 1, int threads = 1,
    Shadows shadows = Shadows::none)
{
    Settings settings;
    settings.samples = samples;
    settings.shadows = shadows;
    settings.aovs = {Aov::item};
    Renderer renderer(threads);
    settings.engine = Engine::cpu;
    Film film;
    renderer.render(world, view, settings, film);
    return film;
}

/// Materials that show their colour, whatever shines on them.
void make_unlit(Scene& scene, std::mt19937& random)
{
    const auto share = [&] { return float(random() % 256) / 255; };
    for (Material& material : scene.materials) {
        material.model = Unlit{.color = {share(), share(), share()}};
        if (random() % 2 == 0) material.alpha = AlphaMode::blend;
    }
    scene.background = {0.25f, 0.5f, 0.75f};
}

/// All that a ray hits and that is there, nearest first, composited.
glm::dvec3 expected_color(const World& world, const EyeWorld& eye, const glm::vec3& d)
{
    const Scene& scene = *world.scene;
    const EyeTriangles& triangles = eye.triangles;
    std::vector<std::uint32_t> hits;
    Effort effort;
    for (std::uint32_t t = 0; t < scene.index.size(); ++t)
        if (is_hit(triangles[t], d, effort) && triangles.is_there(t, d)) hits.push_back(t);
    std::sort(hits.begin(), hits.end(), [&](std::uint32_t a, std::uint32_t b) {
        const int order = compare_depth(triangles[a], triangles[b], d, effort);
        return order < 0 || (order == 0 && a < b);
    });
    glm::dvec3 color(0);
    double through = 1;
    for (const std::uint32_t t : hits) {
        const Material& material = scene.materials[scene.instances[scene.owner[t]].material];
        const auto [u, v] = rounded_barycentrics(triangles[t], d);
        const double alpha =
            material.alpha == AlphaMode::blend ? double(opacity(scene, t, u, v)) : 1;
        color += through * alpha * glm::dvec3(std::get<Unlit>(material.model).color);
        through *= 1 - alpha;
    }
    return color + through * glm::dvec3(scene.background);
}

TEST(Layers, AreAllHitsFrontToBack)
{
    const View view = straight_view(kSize, kSize, kSize);
    std::size_t deep = 0; // pixels that show more than their item's colour
    for (const AdversarialScene& scene : adversarial_scenes()) {
        for (unsigned seed = 0; seed < 2; ++seed) {
            SCOPED_TRACE(scene.name + ", seed " + std::to_string(seed));
            std::mt19937 random(seed);
            TestWorld made;
            scene.fill(made, random);
            made.finish();
            make_cutouts(made, random, seed == 0);
            make_unlit(*made.scene, random);
            const World& world = made.world;
            const EyeWorld eye(world, view);
            const Film film = colors(world, view, 1, int(1 + seed));
            EXPECT_EQ(differences(film.item, brute_items(world, view), kSize), 0u);
            std::size_t wrong = 0;
            for (int k = 0; k < kSize * kSize; ++k) {
                const glm::dvec3 expected =
                    expected_color(world, eye, eye.ray(k % kSize, k / kSize));
                const float* found = &film.color.value[3 * std::size_t(k)];
                for (int c = 0; c < 3; ++c) wrong += !(std::abs(found[c] - expected[c]) < 1e-5);
                const std::uint32_t item = film.item[std::size_t(k)];
                if (item == kNoItem) continue;
                const Scene& s = *made.scene;
                const Material& material = s.materials[s.instances[s.owner[item]].material];
                deep += std::abs(found[0] - std::get<Unlit>(material.model).color.r) > 0.01f;
            }
            EXPECT_EQ(wrong, 0u);
        }
    }
    EXPECT_GT(deep, 2000u);
}

TEST(Layers, OfSeveralSamplesAreTheirMean)
{
    std::mt19937 random(4);
    TestWorld made;
    adversarial_scenes()[0].fill(made, random);
    made.finish();
    make_cutouts(made, random, true);
    make_unlit(*made.scene, random);
    constexpr int kSmall = kSize / 2;
    const Film fine = colors(made.world, straight_view(kSize, kSize, kSize)),
               mean = colors(made.world, straight_view(kSmall, kSmall, kSmall), 2);
    ASSERT_EQ(mean.color.value.size(), std::size_t(3 * kSmall * kSmall));
    for (std::size_t y = 0; y < kSmall; ++y)
        for (std::size_t k = 0; k < 3 * kSmall; ++k) {
            const std::size_t at = 2 * y * 3 * kSize + k / 3 * 6 + k % 3;
            const float sum = fine.color.value[at] + fine.color.value[at + 3] +
                              fine.color.value[at + 3 * kSize] +
                              fine.color.value[at + 3 * kSize + 3];
            ASSERT_NEAR(mean.color.value[y * 3 * kSmall + k], sum / 4, 1e-5f);
        }
}

/// A region of a picture has the picture's colours.
TEST(Layers, OfARegionAreTheSame)
{
    std::mt19937 random(6);
    TestWorld made;
    adversarial_scenes()[1].fill(made, random);
    made.finish();
    make_cutouts(made, random, true);
    make_unlit(*made.scene, random);
    View view = straight_view(kSize, kSize, kSize);
    const Film whole = colors(made.world, view);
    view.region = {11, 7, 20, 30};
    const Film part = colors(made.world, view);
    for (std::size_t y = 0; y < 30; ++y)
        for (std::size_t x = 0; x < 60; ++x)
            ASSERT_EQ(
                part.color.value[y * 60 + x], whole.color.value[(y + 7) * 3 * kSize + 33 + x]);
}

/// A pane before a wall that is lit: both are shaded and shadowed as each would be alone.
TEST(Layers, AreLitAsIfEachWereOpaque)
{
    const View view = straight_view(64, 64, 64);
    for (const Shadows shadows : {Shadows::none, Shadows::exact, Shadows::map}) {
        for (const float opacity : {0.25f, 0.75f}) {
            const auto picture = [&](AlphaMode alpha, float of_pane) {
                TestWorld made;
                made.add({-3, -3, 4}, {3, -3, 4}, {3, 3, 4});
                made.add({-3, -3, 4}, {3, 3, 4}, {-3, 3, 4});
                made.add({-0.5f, -0.6f, 2}, {0.7f, -0.4f, 2.2f}, {0.1f, 0.6f, 2.1f});
                made.finish();
                Scene& scene = *made.scene;
                scene.instances.assign(2, scene.instances[0]);
                scene.instances[0].triangle_count = 2;
                scene.instances[1].first_triangle = 2;
                scene.instances[1].triangle_count = 1;
                scene.instances[1].material = 1;
                scene.owner = {0, 0, 1};
                scene.materials.resize(2);
                scene.materials[1].alpha = alpha;
                scene.materials[1].opacity = of_pane;
                scene.materials[1].alpha_cutoff = 0.5f;
                for (glm::vec3& n : made.world.normal) n = {0, 0, -1};
                made.world.lights = scene.lights = {point_light({1.5, -1, -1})};
                return colors(made.world, view, 1, 1, shadows);
            };
            const Film both = picture(AlphaMode::blend, opacity);
            const Film pane = picture(AlphaMode::opaque, 1);
            // Behind it: the wall without the pane, where the pane shadows nothing.
            const Film wall = picture(AlphaMode::mask, 0);
            std::size_t seen = 0;
            for (std::size_t k = 0; k < both.item.size(); ++k) {
                if (both.item[k] != 2) continue;
                ++seen;
                if (opacity >= 0.5f && shadows != Shadows::none) continue; // it shadows the wall
                for (std::size_t c = 3 * k; c < 3 * k + 3; ++c)
                    ASSERT_NEAR(both.color.value[c],
                        opacity * pane.color.value[c] + (1 - opacity) * wall.color.value[c], 2e-6f);
            }
            EXPECT_GT(seen, 300u);
        }
    }
}

} // namespace
} // namespace firsthit::test
