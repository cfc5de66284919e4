// sky_test.cpp - the light of the sky: against brute force, in closed form, and the same bits everywhere.
#include "instruction_sets.h"
#include "message_of.h"
#include "rays/brute_shadows.h"
#include "sky_scene.h"

#include <firsthit/firsthit.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>

namespace firsthit::test {
namespace {

/// Whether a direction of the sky is open to what a pixel sees, by testing all triangles. Empty where
/// rounding decides which side of the surface the direction is on.
std::optional<bool> is_open(
    const SkyScene& scene, const Film& film, std::size_t pixel, const glm::dvec3& w)
{
    const World& world = scene.world.world;
    const glm::dvec3 normal(at(film[Aov::geometric_normal], pixel));
    const double facing = glm::dot(normal, w);
    if (std::abs(facing) < 1e-6) return {};
    if (facing < 0) return false;
    const Light light{.kind = Light::Kind::directional, .direction = -w};
    const PencilSpace space = light_space(light, scene.view.camera.eye);
    const std::vector<glm::vec3> corner = all_to_light(space, world.position);
    const LightTriangles triangles{corner, world.scene->index};
    Effort effort;
    const std::uint32_t item = film.item[pixel];
    const Corners c = triangles[item];
    const glm::vec3 d = lifted(space, to_light(space, at(film[Aov::position], pixel)),
        receiver_of(c, light_side(space, c, effort)));
    return !is_shadowed_brute(space, triangles, d, item, effort);
}

TEST(Sky, OfAPictureEqualsBruteForceInEveryDirection)
{
    constexpr int kDirections = 13;
    std::size_t compared = 0, unclear = 0, dark = 0;
    for (unsigned seed = 0; seed < 3; ++seed) {
        const SkyScene scene(seed);
        Settings settings = sky_settings(kDirections);
        settings.aovs = {Aov::item, Aov::position, Aov::normal, Aov::geometric_normal};
        const Film film = scene.render(settings);
        const auto directions = sky_directions(kDirections, scene.view.camera.up);
        const glm::vec3 up(glm::normalize(scene.view.camera.up));
        float full = 0;
        for (const glm::dvec3& w : directions) full += glm::dot(glm::vec3(w), up);
        for (std::size_t pixel = 0; pixel < film.item.size(); ++pixel) {
            if (film.item[pixel] == kNoItem) continue;
            const glm::vec3 n = at(film[Aov::normal], pixel);
            float open = 0, seen = 0;
            bool clear = true;
            for (const glm::dvec3& w : directions) {
                const float cosine = std::max(0.0f, glm::dot(n, glm::vec3(w)));
                const auto is = is_open(scene, film, pixel, w);
                clear &= is.has_value();
                open += cosine;
                if (is.value_or(false)) seen += cosine;
            }
            unclear += !clear;
            if (!clear) continue;
            const float rest = 0.02f * full;
            const glm::vec3 light =
                kSkyBlue * (seen / full) + glm::vec3(0.125f) * ((0.5f - 0.5f * glm::dot(n, up)) *
                                                                   ((seen + rest) / (open + rest)));
            const glm::vec3 expected = glm::vec3(1, 0.75f, 0.5f) * light;
            const glm::vec3 color = at(film.color, pixel);
            // One direction more or less is a difference of about a hundredth.
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(color[c], expected[c], 2e-6f) << pixel;
            ++compared;
            dark += seen < 0.5f * open;
        }
    }
    EXPECT_GT(compared, 6000u);
    EXPECT_GT(dark, 200u);
    EXPECT_LT(unclear, compared / 100);
}

TEST(Sky, AnOpenPlaneThatFacesUpReceivesExactlyTheColor)
{
    for (const glm::dvec3& up : {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, 1e200)})
        for (int directions : {1, 2, 7, 32, 64, 256}) {
            SkyScene scene(0, 0);
            scene.matt(glm::vec3(1));
            Settings settings = sky_settings(directions);
            settings.sky.up = up;
            settings.aovs = {Aov::item};
            const Film film = scene.render(settings);
            std::size_t hits = 0;
            for (std::size_t pixel = 0; pixel < film.item.size(); ++pixel) {
                if (film.item[pixel] == kNoItem) continue;
                ++hits;
                ASSERT_EQ(at(film.color, pixel), kSkyBlue) << directions;
            }
            EXPECT_GT(hits, 1000u);
        }
}

TEST(Sky, APlaneThatFacesDownReceivesExactlyTheGround)
{
    SkyScene scene(0, 0);
    scene.matt(glm::vec3(1));
    scene.view.camera.eye = {1, -9, -7};
    scene.view.camera.direction = {-0.1, 1, 0.8};
    scene.view.camera.up = {0, 0, 1};
    const Film film = scene.render(sky_settings(16));
    EXPECT_EQ(at(film.color, kMiddle), glm::vec3(0.125f));
}

TEST(Sky, NothingOfItEntersAClosedBox)
{
    SkyScene scene(0, 0);
    scene.box({-2, -2, 1}, {4, 4, 3}, 0);
    scene.world.finish();
    scene.matt(glm::vec3(1));
    scene.view.camera.eye = {0.3, -1.9, 2.2};
    scene.view.camera.direction = {0.05, 1, -0.3};
    Settings settings = sky_settings(24);
    settings.sky.ground = glm::vec3(0);
    settings.aovs = {Aov::item};
    const Film film = scene.render(settings);
    for (std::size_t pixel = 0; pixel < film.item.size(); ++pixel) {
        ASSERT_NE(film.item[pixel], kNoItem);
        ASSERT_EQ(at(film.color, pixel), glm::vec3(0));
    }
    // But for what its walls send on.
    settings.sky.bounce = 0.25f;
    settings.sky.up = {0, 0, 1};
    settings.aovs = {Aov::geometric_normal};
    const Film lit = scene.render(settings);
    std::size_t floor = 0;
    for (std::size_t pixel = 0; pixel < film.item.size(); ++pixel) {
        if (at(lit[Aov::geometric_normal], pixel).z < 0.99f) continue;
        ++floor;
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(at(lit.color, pixel)[c], 0.25f * kSkyBlue[c], 1e-6f);
    }
    EXPECT_GT(floor, 100u);
}

TEST(Sky, LightsSmoothSurfacesByTheirNormals)
{
    SkyScene scene(0, 0);
    scene.matt(glm::vec3(1));
    const glm::vec3 n = glm::normalize(glm::vec3(0.3f, -0.5f, 0.8f));
    scene.world.world.normal.assign(scene.world.world.position.size(), n);
    const Film film = scene.render(sky_settings(64));
    // The plane hides the directions below it, so that less than the hemisphere of n is open.
    const glm::vec3 color = at(film.color, kMiddle);
    const float cosine = glm::dot(n, glm::vec3(glm::normalize(scene.view.camera.up)));
    EXPECT_NEAR(color.x, 0.25f * (0.5f + 0.5f * cosine) + 0.125f * (0.5f - 0.5f * cosine), 0.01f);
}

TEST(Sky, IsTheSameForThreadsTilesAndInstructionSets)
{
    const SkyScene scene(4);
    const Settings settings = sky_settings(19);
    const std::vector<float> expected = scene.render(settings, 1).color.value;
    EXPECT_EQ(scene.render(settings, 5).color.value, expected);
    for (int tile : {8, 24, 128}) {
        Settings tiled = settings;
        tiled.tile_size = tile;
        EXPECT_EQ(scene.render(tiled, 2).color.value, expected) << tile;
    }
    for_instruction_sets([&] { EXPECT_EQ(scene.render(settings, 2).color.value, expected); });
}

TEST(Sky, OfARegionIsThatOfThePicture)
{
    SkyScene scene(5);
    const Film all = scene.render(sky_settings(11));
    scene.view.region = {19, 7, 33, 41};
    const Film part = scene.render(sky_settings(11));
    for (int y = 0; y < 41; ++y)
        for (int x = 0; x < 33; ++x)
            ASSERT_EQ(at(part.color, std::size_t(y * 33 + x)),
                at(all.color, std::size_t((y + 7) * 72 + x + 19)));
}

TEST(Sky, OfSeveralSamplesIsTheMeanOfAFinerPicture)
{
    SkyScene scene(6);
    Settings settings = sky_settings(9);
    settings.samples = 2;
    const Film coarse = scene.render(settings);
    settings.samples = 1;
    scene.view.width *= 2, scene.view.height *= 2;
    const Film fine = scene.render(settings);
    for (int y = 0; y < 56; ++y)
        for (int x = 0; x < 72; ++x) {
            glm::vec3 sum(0);
            for (int k = 0; k < 4; ++k)
                sum += at(fine.color, std::size_t((2 * y + k / 2) * 144 + 2 * x + k % 2));
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(at(coarse.color, std::size_t(y * 72 + x))[c], sum[c] / 4, 1e-6f);
        }
}

TEST(Sky, OfAnInterleavedPictureIsThatOfTheSamplesThatAreShot)
{
    const SkyScene scene(7);
    Settings settings = sky_settings(10);
    const Film all = scene.render(settings);
    for (int every : {2, 4, 8}) {
        settings.interleave = every;
        settings.interpolate = false;
        const Film some = scene.render(settings);
        std::size_t shot = 0;
        for (std::size_t pixel = 0; pixel < 72 * 56; ++pixel) {
            const glm::vec3 color = at(some.color, pixel);
            if (color == glm::vec3(0)) continue;
            ++shot;
            ASSERT_EQ(color, at(all.color, pixel)) << every;
        }
        EXPECT_GT(shot, std::size_t(2000 / every));
    }
}

TEST(Sky, AddsToLightsAndLeavesThePlanesOfLightsAlone)
{
    SkyScene scene(8);
    scene.world.world.lights = {{.position = {3, -4, 12}}};
    Settings settings;
    settings.aovs = {Aov::lit, Aov::item};
    const Film lamp = scene.render(settings);
    settings.sky = sky_settings(8).sky;
    const Film both = scene.render(settings);
    settings.shadows = Shadows::none;
    const Film unshadowed = scene.render(settings);
    scene.world.world.lights.clear();
    const Film sky = scene.render(sky_settings(8));
    EXPECT_EQ(both[Aov::lit].value, lamp[Aov::lit].value);
    std::size_t brighter = 0;
    for (std::size_t pixel = 0; pixel < both.item.size(); ++pixel)
        for (int c = 0; c < 3; ++c) {
            ASSERT_NEAR(at(both.color, pixel)[c],
                at(lamp.color, pixel)[c] + at(sky.color, pixel)[c], 1e-6f);
            brighter += at(unshadowed.color, pixel)[c] > at(both.color, pixel)[c];
        }
    EXPECT_GT(brighter, 100u) << "shadows of lamps, but not of the sky, are switched off";
}

TEST(Sky, DimsEnvironmentsWhereItIsHiddenAndAddsNothing)
{
    SkyScene scene(9);
    MetallicRoughness model;
    model.metallic = 0;
    scene.world.scene->materials[0].model = model;
    scene.world.scene->environment.map = constant_environment(glm::vec3(0.5f));
    Settings settings;
    settings.aovs = {Aov::item};
    const Film open = scene.render(settings);
    settings.sky = sky_settings(16).sky;
    const Film film = scene.render(settings);
    std::size_t darker = 0, equal = 0;
    for (std::size_t pixel = 0; pixel < film.item.size(); ++pixel) {
        if (film.item[pixel] == kNoItem) continue;
        ASSERT_LE(at(film.color, pixel).x, at(open.color, pixel).x);
        equal += at(film.color, pixel) == at(open.color, pixel);
        darker += at(film.color, pixel).x < 0.8f * at(open.color, pixel).x;
    }
    EXPECT_GT(darker, 100u);
    EXPECT_GT(equal, 100u);
}

TEST(Sky, DoesNotLightWhatIsUnlit)
{
    SkyScene scene(9);
    scene.world.scene->materials[0].model = Unlit{.color = glm::vec3(0.5f)};
    const Film film = scene.render(sky_settings(5));
    EXPECT_EQ(at(film.color, kMiddle), glm::vec3(0.5f));
}

TEST(Sky, DirectionsAreEvenOverTheUpperHemisphere)
{
    const glm::dvec3 up = glm::normalize(glm::dvec3(1, 2, -3));
    for (int count : {1, 2, 16, 64, 256}) {
        const auto directions = sky_directions(count, up * 7.0);
        ASSERT_EQ(directions.size(), std::size_t(count));
        glm::dvec3 sum(0);
        for (int k = 0; k < count; ++k) {
            EXPECT_NEAR(glm::length(directions[std::size_t(k)]), 1, 1e-12);
            EXPECT_NEAR(glm::dot(directions[std::size_t(k)], up), (k + 0.5) / count, 1e-12);
            sum += directions[std::size_t(k)];
        }
        if (count < 16) continue;
        EXPECT_NEAR(glm::distance(sum / double(count), 0.5 * up), 0, 0.7 / count);
        double nearest = 2;
        for (const glm::dvec3& a : directions)
            for (const glm::dvec3& b : directions)
                if (&a != &b) nearest = std::min(nearest, glm::distance(a, b));
        EXPECT_GT(nearest, 1.2 / std::sqrt(count));
    }
}

TEST(Sky, WhatIsOutOfRangeIsRefused)
{
    const SkyScene scene(0, 0);
    const auto refused = [&](const auto& change) {
        Settings settings = sky_settings(8);
        change(settings.sky);
        return message_of<ArgumentError>([&] { scene.render(settings, 1); });
    };
    EXPECT_EQ(refused([](Sky& sky) { sky.directions = -1; }),
        "-1 directions of the sky is out of range: 0 to 256");
    EXPECT_EQ(refused([](Sky& sky) { sky.directions = 257; }),
        "257 directions of the sky is out of range: 0 to 256");
    EXPECT_EQ(refused([](Sky& sky) { sky.color.y = -0.5f; }),
        "the sky's light (0.25, -0.5, 1) is out of range: accepted are finite numbers, 0 or more");
    EXPECT_NE(refused([](Sky& sky) {
        sky.ground.x = std::numeric_limits<float>::infinity();
    }).find("out of range"),
        std::string::npos);
    EXPECT_NE(refused([](Sky& sky) {
        sky.up.z = std::numeric_limits<double>::quiet_NaN();
    }).find("is no direction"),
        std::string::npos);
    EXPECT_EQ(refused([](Sky& sky) { sky.bounce = 1.5f; }),
        "the sky's bounce 1.5 is out of range: 0 to 1");
    EXPECT_EQ(message_of<ArgumentError>([] { sky_directions(3, glm::dvec3(0)); }),
        "the sky's up (0, 0, 0) is no direction: accepted is any finite vector but 0");
    Occlusion occlusion(1);
    std::vector<glm::vec3> light;
    const std::vector<glm::vec3> one(1), two(2);
    EXPECT_EQ(message_of<ArgumentError>([&] {
        sky_light(occlusion, scene.world.world, {.directions = 4, .up = {0, 0, 1}}, {two, one, {}},
            light);
    }),
        "1 normals for 2 points: one for each is accepted");
}

} // namespace
} // namespace firsthit::test
