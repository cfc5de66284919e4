// film_planes_test.cpp - the light of a tile goes to its pixels.
#include "cpu/film_planes.h"

#include "film/film_size.h"
#include "items.h"
#include "scene/model/borrow.h"
#include "scenes.h"

#include <firsthit/render.h>

#include <gtest/gtest.h>

#include <limits>

namespace firsthit {
namespace {

TEST(FilmPlanes, LightGoesToThePixelsOfTheTileThatHaveAnItem)
{
    // The second of two tiles of 8 x 8, cut off by a picture of 14 x 5.
    constexpr std::size_t kSamples = 64, kLights = 3;
    ViewMemory view;
    view.tile_size = 8;
    view.tiles_x = 2;
    alignas(64) std::uint32_t item[kSamples];
    alignas(64) float lit[kLights * kSamples], zero[kSamples] = {};
    for (std::size_t k = 0; k < kSamples; ++k) {
        item[k] = k % 3 == 0 ? kNoItem : 7;
        for (std::size_t light = 0; light < kLights; ++light)
            lit[light * kSamples + k] =
                k % 3 == 0 ? std::numeric_limits<float>::quiet_NaN() : float(100 * light + k);
    }
    HitTile hits;
    hits.size = 8;
    hits.item = item;
    hits.t = hits.u = hits.v = zero;

    Film film;
    const Aov aovs[] = {Aov::lit};
    const Region all{0, 0, 14, 5};
    resize(film, all, {false, aovs, kLights});
    store_tile({view, all, all, 1, 1}, hits, {lit, kSamples}, {}, film);

    for (int y = 0; y < 5; ++y)
        for (int x = 8; x < 14; ++x)
            for (std::size_t light = 0; light < kLights; ++light) {
                const auto k = std::size_t(tile_offset(x - 8, y, 8));
                const float expected = k % 3 == 0 ? 0.0f : float(100 * light + k);
                EXPECT_EQ(film[Aov::lit].value[std::size_t(y * 14 + x) * kLights + light], expected)
                    << x << " " << y << " " << light;
            }
}

TEST(FilmPlanes, ColourIsTheSameWhetherOrNotThereAreOtherPlanes)
{
    // Other planes need hits of blocks and tiles without an item as well.
    const Scene scene = load_scene("builtin:torus");
    World world;
    pose(borrow(scene), 0, world);
    ASSERT_FALSE(world.lights.empty());
    View view{.camera = framing_camera(world), .width = 203, .height = 150, .region = {}};
    for (const Shadows shadows : {Shadows::none, Shadows::map, Shadows::exact}) {
        Settings settings;
        settings.shadows = shadows;
        settings.tile_size = 16;
        Renderer renderer(1);
        Film film, with_planes;
        // What is covered moves: memory still holds what was there in the frame before.
        for (const double step : {0.0, 0.2, -0.3}) {
            view.camera = framing_camera(world);
            view.camera.direction.x += step;
            settings.aovs = {};
            renderer.render(world, view, settings, film);
            settings.aovs = {Aov::depth, Aov::item, Aov::lit, Aov::normal};
            Renderer(1).render(world, view, settings, with_planes);
            EXPECT_EQ(film.color.value, with_planes.color.value) << int(shadows) << " " << step;
        }
    }
}

/// Seen from `height` above or below it, at coordinates where float has steps of 6 cm.
struct FarFloor {
    test::TestWorld world;
    View view;

    FarFloor(double height, bool reversed)
    {
        const glm::vec3 a(999990, 1000000, 999990), b(1000020, 1000000, 999990),
            c(999990, 1000000, 1000020);
        if (reversed)
            world.add(a, b, c);
        else
            world.add(a, c, b);
        world.finish();
        for (glm::vec3& n : world.world.normal) n = {0, 1, 0};
        view.width = view.height = 16;
        view.camera = {.eye = {999995, 1000000 + height, 999995},
            .direction = {1, -0.1 * (height > 0 ? 1 : -1), 1}};
    }
};

TEST(FilmPlanes, NormalsLookAtAnEyeThatIsNearerToTheirPlaneThanFloatsSteps)
{
    for (const double height : {0.03, -0.03, 0.001, -1e-5, 0.05, -2.0})
        for (const bool reversed : {false, true}) {
            SCOPED_TRACE(height);
            const FarFloor floor(height, reversed);
            const Film film = test::render_planes(
                floor.world.world, floor.view, {Aov::item, Aov::normal, Aov::geometric_normal})
                                  .film;
            int hits = 0;
            for (std::size_t i = 0; i < film.item.size(); ++i) {
                if (film.item[i] == kNoItem) continue;
                ++hits;
                const float up = height > 0 ? 1.0f : -1.0f;
                EXPECT_EQ(film[Aov::geometric_normal].value[3 * i + 1], up);
                EXPECT_GT(film[Aov::normal].value[3 * i + 1] * up, 0);
            }
            EXPECT_GT(hits, 30);
        }
}

} // namespace
} // namespace firsthit
