// holes_test.cpp - pixels whose triangle is not found.
#include "holed_robots.h"

namespace firsthit::test {
namespace {

bool some(int x, int y)
{
    return (x * 7 + y * 13) % 31 == 0 || (x > 40 && x < 45 && y > 20 && y < 26);
}

TEST(Holes, GetTheColoursAroundThem)
{
    const Robots robots;
    const Film whole = robots.render({}).film;
    HoledSource source(some);
    const Rendered ours = robots.render({}, &source, 3);
    EXPECT_EQ(ours.film.color.value, robots.filled(whole.color.value, some));
    EXPECT_GT(ours.stats.missed, 200u);
    EXPECT_EQ(ours.stats.interpolated, ours.stats.missed);
}

TEST(Holes, AreBackgroundWithoutInterpolation)
{
    const Robots robots;
    const Film whole = robots.render({}).film;
    Settings settings;
    settings.interpolate = false;
    HoledSource source(some), nothing([](int, int) { return true; });
    const std::vector<float> background = robots.render(settings, &nothing).film.color.value;
    const Rendered ours = robots.render(settings, &source);
    for (std::size_t k = 0; k < background.size(); ++k) {
        const int pixel = int(k / 3);
        const bool hole = some(pixel % robots.view.width, pixel / robots.view.width);
        ASSERT_EQ(ours.film.color.value[k], (hole ? background : whole.color.value)[k]);
    }
    EXPECT_GT(ours.stats.missed, 200u);
    EXPECT_EQ(ours.stats.interpolated, 0u);
}

TEST(Holes, AmongSeveralSamplesLeaveTheMeanOfTheOthers)
{
    const Robots robots;
    Settings settings;
    settings.samples = 2;
    const auto first = [](int x, int y) { return x % 2 == 0 && y % 2 == 0; };
    const auto others = [&](int x, int y) { return !first(x, y); };
    HoledSource without_first(first), only_first(others);
    const auto all = robots.render(settings).film.color.value;
    const auto three = robots.render(settings, &without_first);
    const auto one = robots.render(settings, &only_first).film.color.value;
    EXPECT_EQ(three.stats.missed, robots.pixels());
    EXPECT_EQ(three.stats.interpolated, 0u);
    for (std::size_t k = 0; k < all.size(); ++k)
        ASSERT_NEAR((3 * three.film.color.value[k] + one[k]) / 4, all[k], 1e-5f);
}

TEST(Holes, ThatAreAllSamplesOfAPixelAreFilled)
{
    const Robots robots;
    Settings settings;
    settings.samples = 3;
    HoledSource source([](int x, int y) { return x / 3 == 50 && y / 3 == 30; });
    const auto whole = robots.render(settings).film.color.value;
    const auto is_hole = [](int x, int y) { return x == 50 && y == 30; };
    const Rendered ours = robots.render(settings, &source);
    EXPECT_EQ(ours.film.color.value, robots.filled(whole, is_hole));
    EXPECT_EQ(ours.stats.missed, 9u);
    EXPECT_EQ(ours.stats.interpolated, 1u);
}

} // namespace
} // namespace firsthit::test
