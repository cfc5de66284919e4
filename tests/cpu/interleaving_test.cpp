// interleaving_test.cpp - frames that shoot the rays of some pixels, and fill in the others.
#include "base/pixel_steps.h"
#include "film/spread_pixels.h"
#include "holed_robots.h"
#include "random_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace firsthit::test {
namespace {

TEST(PixelSteps, ShootOnePixelInN)
{
    for (int every = -20; every <= 40; ++every)
        EXPECT_EQ(PixelSteps::is_known(every),
            every == 1 || every == 2 || every == 4 || every == 8 || every == 16)
            << every;
    for (const auto& [every, x, y] :
        {std::array{1, 1, 1}, {2, 2, 1}, {4, 2, 2}, {8, 4, 2}, {16, 4, 4}}) {
        const PixelSteps steps = PixelSteps::of(every);
        EXPECT_EQ(steps.x, x);
        EXPECT_EQ(steps.y, y);
        EXPECT_EQ(steps.all(), every == 1);
    }
}

TEST(PixelSteps, CountTheShotPixelsOfARegion)
{
    for (const int every : {1, 2, 4, 8, 16}) {
        const PixelSteps steps = PixelSteps::of(every);
        for (int x = 0; x < 9; ++x) {
            for (int width = 1; width < 9; ++width) {
                const Region region{x, 2 * x, width, 9 - width};
                const Region shot = steps.shot(region);
                int count = 0;
                for (int py = region.y; py < region.y + region.height; ++py) {
                    for (int px = region.x; px < region.x + region.width; ++px) {
                        if (!steps.is_shot(px, py)) continue;
                        ++count;
                        EXPECT_GE(px / steps.x, shot.x);
                        EXPECT_LT(px / steps.x, shot.x + shot.width);
                        EXPECT_GE(py / steps.y, shot.y);
                        EXPECT_LT(py / steps.y, shot.y + shot.height);
                    }
                }
                EXPECT_EQ(count, shot.width * shot.height);
            }
        }
    }
}

/// Spreads noise over regions of many sizes and places, as fill_holes does with all other pixels as holes.
TEST(SpreadPixels, FillsAsHolesAreFilled)
{
    std::mt19937 random(3);
    for (const int every : {2, 4, 8, 16}) {
        const PixelSteps steps = PixelSteps::of(every);
        for (int round = 0; round < 60; ++round) {
            const int most = round < 40 ? 40 : 700;
            const Region region{whole(random, 0, 30), whole(random, 0, 30), whole(random, 1, most),
                whole(random, 1, 40)};
            const Region shot = steps.shot(region);
            const auto pixels = std::size_t(region.width) * std::size_t(region.height);
            std::vector<float> known, color(3 * pixels, -1.0f), expected(3 * pixels, -1.0f);
            std::vector<std::uint8_t> hole(pixels, 1);
            for (std::size_t k = 0; k < pixels; ++k) {
                const int x = region.x + int(k) % region.width;
                const int y = region.y + int(k) / region.width;
                if (!steps.is_shot(x, y)) continue;
                hole[k] = 0;
                for (std::size_t c = 0; c < 3; ++c) {
                    known.push_back(uniform(random, 0, 1));
                    expected[3 * k + c] = known.back();
                }
            }
            std::vector<float> placed(3 * pixels, -1.0f);
            const std::vector<float> only_known = expected;
            const std::uint64_t filled =
                fill_holes({region.width, region.height, hole, expected}, 0, region.height);
            const int middle = region.height / 3;
            const SpreadPicture picture{steps, region, known, color};
            std::uint64_t made = spread_pixels(picture, 0, middle);
            made += spread_pixels(picture, middle, region.height);
            if (shot.width <= 0 || shot.height <= 0) {
                EXPECT_EQ(made, 0u);
                continue;
            }
            ASSERT_EQ(color, expected) << every << ": " << region.x << "," << region.y << " "
                                       << region.width << "x" << region.height;
            EXPECT_EQ(made, filled);
            place_pixels({steps, region, known, placed}, 0, middle);
            place_pixels({steps, region, known, placed}, middle, region.height);
            EXPECT_EQ(placed, only_known);
        }
    }
}

TEST(Interleaving, ShootsEveryStepAndFillsTheRest)
{
    const Robots robots; // textured
    const Film whole = robots.render({}).film;
    for (const int every : {2, 4, 8, 16}) {
        Settings settings;
        settings.interleave = every;
        const PixelSteps steps = PixelSteps::of(every);
        const auto is_hole = [&](int x, int y) { return !steps.is_shot(x, y); };
        const Rendered ours = robots.render(settings);
        EXPECT_EQ(ours.film.color.value, robots.filled(whole.color.value, is_hole)) << every;
        EXPECT_EQ(ours.stats.missed, 0u);
        EXPECT_EQ(ours.stats.interpolated,
            robots.pixels() - std::size_t((100 / steps.x + 1) * (66 / steps.y + 1)));
    }
}

TEST(Interleaving, ShootsTheSameRaysWithAnyLightsAndCameras)
{
    Robots robots;
    Light lamp, spot, sun;
    lamp.position = {1, 6, 2};
    spot.kind = Light::Kind::spot;
    spot.position = {0, 7, 0};
    sun.kind = Light::Kind::directional;
    sun.direction = {-0.4, -1, 0.3};
    robots.world.lights = {lamp, spot, sun};
    const Camera plain = robots.view.camera;
    for (const bool skewed : {false, true}) {
        robots.view.camera = plain;
        if (skewed) {
            robots.view.camera.focal = glm::dvec2(80.3, 91.7);
            robots.view.camera.principal_point = glm::dvec2(43.21, 30.07);
            robots.view.camera.skew = 3.7;
        }
        for (const Shadows shadows : {Shadows::none, Shadows::exact}) {
            for (const int every : {2, 4, 8, 16}) {
                const PixelSteps steps = PixelSteps::of(every);
                Settings settings;
                settings.shadows = shadows;
                settings.interpolate = false;
                const std::vector<float> whole = robots.render(settings).film.color.value;
                settings.interleave = every;
                const std::vector<float> some = robots.render(settings).film.color.value;
                for (int y = 0; y < robots.view.height; y += steps.y)
                    for (int x = 0; x < robots.view.width; x += steps.x)
                        for (int c = 0; c < 3; ++c) {
                            const auto k =
                                3 * std::size_t(y * robots.view.width + x) + std::size_t(c);
                            ASSERT_EQ(some[k], whole[k]) << every << ": " << x << " " << y;
                        }
            }
        }
    }
}

TEST(Interleaving, MakesTheSameBitsWithAnyThreadsAndTiles)
{
    const Robots robots;
    Settings settings;
    settings.interleave = 2;
    const Film expected = robots.render(settings).film;
    EXPECT_EQ(robots.render(settings, nullptr, 4).film.color.value, expected.color.value);
    settings.tile_size = 24;
    EXPECT_EQ(robots.render(settings, nullptr, 2).film.color.value, expected.color.value);
}

TEST(Interleaving, LeavesPlanesWhole)
{
    const Robots robots;
    Settings settings;
    settings.aovs = {Aov::item, Aov::depth, Aov::lit};
    const Film whole = robots.render(settings).film;
    settings.interleave = 4;
    const Film film = robots.render(settings).film;
    EXPECT_EQ(film.item, whole.item);
    EXPECT_EQ(film[Aov::depth].value, whole[Aov::depth].value);
    EXPECT_EQ(film[Aov::lit].value, whole[Aov::lit].value);
    EXPECT_NE(film.color.value, whole.color.value);
}

TEST(Interleaving, OfARegionShootsThePicturesPixels)
{
    Robots robots;
    Settings settings;
    settings.interleave = 8;
    settings.interpolate = false;
    const Film whole = robots.render(settings).film;
    robots.view.region = {13, 6, 50, 40};
    const Film part = robots.render(settings).film;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 50; ++x)
            ASSERT_EQ(part.color.value[std::size_t(y * 50 + x) * 3],
                whole.color.value[std::size_t((y + 6) * robots.view.width + x + 13) * 3]);
}

TEST(Interleaving, FillsWhatIsShotAndMissed)
{
    const Robots robots;
    Settings settings;
    settings.interleave = 4;
    HoledSource all_missed([](int, int) { return true; }), some_missed([](int x, int y) {
        return (x + y) % 5 == 0; // of the shot pixels
    });
    const std::uint64_t shot = 51 * 34;
    EXPECT_EQ(robots.render(settings, &all_missed).stats.missed, shot);
    const Rendered ours = robots.render(settings, &some_missed);
    EXPECT_NEAR(double(ours.stats.missed), double(shot) / 5, 2);
    EXPECT_EQ(ours.stats.interpolated, robots.pixels() - shot + ours.stats.missed);
    const auto finite = [](float v) { return v >= 0 && v < 10; };
    const std::vector<float>& color = ours.film.color.value;
    EXPECT_TRUE(std::all_of(color.begin(), color.end(), finite));
    const std::vector<float> all = robots.render(settings).film.color.value;
    double sum = 0;
    for (std::size_t k = 0; k < all.size(); ++k) sum += std::abs(double(color[k]) - double(all[k]));
    EXPECT_LT(sum / double(all.size()), 0.02);
    EXPECT_NE(color, all);
}

TEST(Interleaving, OfARegionWithoutAShotPixelIsBackground)
{
    Robots robots;
    Settings settings;
    settings.interleave = 16;
    robots.view.region = {49, 33, 3, 3};
    const Film film = robots.render(settings).film;
    ASSERT_EQ(film.color.value.size(), 27u);
    for (std::size_t k = 0; k < 27; ++k)
        EXPECT_EQ(film.color.value[k], robots.scene.background[int(k % 3)]);
}

} // namespace
} // namespace firsthit::test
