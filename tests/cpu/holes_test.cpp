// holes_test.cpp - pixels that are not shot, or whose triangle is not found.
#include "cpu/holes.h"
#include "film/fill_holes.h"
#include "items.h"
#include "scene/model/borrow.h"

#include <firsthit/scene.h>

#include <functional>

namespace firsthit::test {
namespace {

/// Our items, but samples are holes where `is_hole` says so.
class HoledSource final : public ItemSource {
  public:
    using IsHole = std::function<bool(int x, int y)>; // sample of the part
    explicit HoledSource(IsHole is_hole) : is_hole_(std::move(is_hole)) {}

    bool start(const World& world, ViewMemory& memory, Tasks& tasks) override
    {
        return ours_.start(world, memory, tasks);
    }
    std::size_t wait(const ViewMemory& memory) override { return ours_.wait(memory); }
    void tile(const ViewMemory& memory, int tile, TileItems& out, std::span<std::uint64_t> holes,
        std::size_t worker) override
    {
        ours_.tile(memory, tile, out, holes, worker);
        const int x0 = memory.first_x(tile), y0 = memory.first_y(tile);
        for (int y = 0; y < out.size && y0 + y < memory.pencil.height; ++y) {
            for (int x = 0; x < out.size && x0 + x < memory.pencil.width; ++x) {
                if (!is_hole_(x0 + x, y0 + y)) continue;
                const auto offset = std::size_t(tile_offset(x, y, out.size));
                out.item[offset] = kNoItem;
                holes[offset / 64] |= std::uint64_t(1) << offset % 64;
            }
        }
    }

  private:
    RasterSource ours_;
    IsHole is_hole_;
};

/// The robots, a few of their pixels.
struct Robots {
    Scene scene = load_scene("builtin:robots");
    World world;
    View view;

    Robots()
    {
        pose(borrow(scene), 1.5, world);
        view.width = 101, view.height = 67;
        view.camera = world.camera;
    }

    Rendered render(const Settings& settings, ItemSource* source = nullptr, int threads = 1) const
    {
        Tasks tasks(threads);
        FrameMemory memory;
        Rendered out;
        const View filled = checked(view);
        render_frame({world, filled, tasks, out.film}, settings, memory, out.stats, {source});
        return out;
    }

    std::size_t pixels() const { return std::size_t(view.width * view.height); }

    /// What filling these pixels makes of the picture.
    std::vector<float> filled(std::vector<float> color, const HoledSource::IsHole& is_hole) const
    {
        std::vector<std::uint8_t> hole;
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) hole.push_back(is_hole(x, y));
        fill_holes({view.width, view.height, hole, color}, 0, view.height);
        return color;
    }
};

bool some(int x, int y)
{
    return (x * 7 + y * 13) % 31 == 0 || (x > 40 && x < 45 && y > 20 && y < 26);
}

TEST(Lattice, HasEveryNthPixelOfEachRowAndNoneFarAway)
{
    for (int every = 1; every <= Lattice::kMost; ++every) {
        const Lattice lattice(every);
        const auto is_shot = [&](int x, int y) {
            const int offset = block_offset(x % 8, y % 8);
            return int(lattice.shot(x / 8 * 8, y / 8 * 8) >> offset & 1);
        };
        const int reach = every < 10 ? 1 : 2;
        for (int y = 2; y < 40; ++y) {
            for (int x = 2; x < 40; ++x) {
                EXPECT_EQ(is_shot(x, y), is_shot(x + every, y));
                int in_period = 0, near = 0;
                for (int k = 0; k < every; ++k) in_period += is_shot(x + k, y);
                for (int dy = -reach; dy <= reach; ++dy)
                    for (int dx = -reach; dx <= reach; ++dx) near += is_shot(x + dx, y + dy);
                EXPECT_EQ(in_period, 1);
                EXPECT_GE(near, 1) << every;
            }
        }
    }
}

TEST(Interleaving, ShootsTheLatticeAndFillsTheRest)
{
    const Robots robots;
    const Film whole = robots.render({}).film;
    for (const int every : {2, 3, 5, 16}) {
        Settings settings;
        settings.interleave = every;
        const Lattice lattice(every);
        const auto is_hole = [&](int x, int y) {
            const int offset = block_offset(x % 8, y % 8);
            return !(lattice.shot(x / 8 * 8, y / 8 * 8) >> offset & 1);
        };
        const Rendered ours = robots.render(settings);
        EXPECT_EQ(ours.film.color.value, robots.filled(whole.color.value, is_hole)) << every;
        EXPECT_EQ(ours.stats.missed, 0u);
        EXPECT_NEAR(double(ours.stats.interpolated), double(robots.pixels()) * (every - 1) / every,
            robots.view.height);
    }
}

TEST(Interleaving, ShootsTheSameRaysWithAnyLights)
{
    Robots robots;
    Light lamp, spot, sun;
    lamp.position = {1, 6, 2};
    spot.kind = Light::Kind::spot;
    spot.position = {0, 7, 0};
    sun.kind = Light::Kind::directional;
    sun.direction = {-0.4, -1, 0.3};
    robots.world.lights = {lamp, spot, sun};
    for (const Shadows shadows : {Shadows::none, Shadows::exact}) {
        Settings settings;
        settings.shadows = shadows;
        settings.interpolate = false;
        const std::vector<float> whole = robots.render(settings).film.color.value;
        settings.interleave = 3;
        const std::vector<float> third = robots.render(settings).film.color.value;
        for (int y = 0; y < robots.view.height; ++y)
            for (int x = (3 - y % 3) % 3; x < robots.view.width; x += 3)
                ASSERT_EQ(third[std::size_t(y * robots.view.width + x) * 3],
                    whole[std::size_t(y * robots.view.width + x) * 3])
                    << x << " " << y;
    }
}

TEST(Interleaving, MakesTheSameBitsWithAnyThreadsAndTiles)
{
    const Robots robots;
    Settings settings;
    settings.interleave = 3;
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
    settings.interleave = 5;
    settings.interpolate = false;
    const Film whole = robots.render(settings).film;
    robots.view.region = {13, 6, 50, 40};
    const Film part = robots.render(settings).film;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 50; ++x)
            ASSERT_EQ(part.color.value[std::size_t(y * 50 + x) * 3],
                whole.color.value[std::size_t((y + 6) * robots.view.width + x + 13) * 3]);
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

TEST(Holes, ThatAreNotShotAreNotMissed)
{
    const Robots robots;
    Settings settings;
    settings.interleave = 2;
    HoledSource even([](int x, int y) { return (x + y) % 2 == 0; }),
        odd([](int x, int y) { return (x + y) % 2 == 1; });
    EXPECT_EQ(robots.render(settings, &odd).stats.missed, 0u);
    EXPECT_EQ(robots.render(settings, &even).stats.missed, (robots.pixels() + 1) / 2);
}

} // namespace
} // namespace firsthit::test
