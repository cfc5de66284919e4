// adaptive_test.cpp - adaptive samples against N x N samples everywhere.
#include "base/srgb.h"
#include "cpu/adversarial_scenes.h"
#include "cutouts.h"
#include "lights.h"
#include "message_of.h"
#include "test_data.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace firsthit::test {
namespace {

struct AdaptiveRun {
    Film film;
    Stats stats;
};

AdaptiveRun render_colors(
    const World& world, const View& view, const Settings& settings, int threads = 1)
{
    Renderer renderer(threads);
    AdaptiveRun run;
    renderer.render(world, view, settings, run.film);
    run.stats = renderer.stats();
    return run;
}

Settings adaptive(int n)
{
    Settings settings;
    settings.adaptive = n;
    return settings;
}

Settings everywhere(int n)
{
    Settings settings;
    settings.samples = n;
    return settings;
}

/// What an adaptive picture is beside those of one sample and of N x N.
struct AdaptiveCounts {
    std::size_t pixels = 0;
    std::size_t sampled = 0; // that differ from one sample
    std::size_t neither = 0; // that have the bits of neither picture
    std::size_t off = 0;     // that are more than one 8-bit code off N x N samples
    std::size_t needed = 0;  // of which one sample is
    std::uint64_t fine = 0;  // Stats::fine_pixels

    void add(const AdaptiveCounts& other)
    {
        pixels += other.pixels, sampled += other.sampled, neither += other.neither;
        off += other.off, needed += other.needed, fine += other.fine;
    }
};

bool far_off(const float* a, const float* b)
{
    int most = 0;
    for (int c = 0; c < 3; ++c)
        most = std::max(most, std::abs(int(srgb_from_linear(a[c])) - int(srgb_from_linear(b[c]))));
    return most > 1;
}

AdaptiveCounts count(const World& world, const View& view, int n, const Settings& base = {})
{
    Settings one = base, fine = base, both = base;
    fine.samples = n;
    both.adaptive = n;
    const AdaptiveRun a = render_colors(world, view, one), b = render_colors(world, view, fine),
                      found = render_colors(world, view, both);
    AdaptiveCounts counts;
    counts.fine = found.stats.fine_pixels;
    counts.pixels = a.film.color.value.size() / 3;
    for (std::size_t k = 0; k < counts.pixels; ++k) {
        const float *p = &a.film.color.value[3 * k], *q = &b.film.color.value[3 * k],
                    *r = &found.film.color.value[3 * k];
        const bool is_one = std::memcmp(p, r, 12) == 0, is_fine = std::memcmp(q, r, 12) == 0;
        counts.sampled += !is_one;
        counts.neither += !is_one && !is_fine;
        counts.off += far_off(r, q);
        counts.needed += far_off(p, q);
    }
    EXPECT_GE(counts.fine, counts.sampled);
    EXPECT_LE(counts.fine, counts.pixels);
    return counts;
}

/// Gives the triangles, by turns, to instances of materials that show these colours.
void paint(TestWorld& made, const std::vector<glm::vec3>& colors)
{
    Scene& scene = *made.scene;
    scene.materials.clear();
    scene.instances.clear();
    for (const glm::vec3& color : colors) {
        Material material;
        material.model = Unlit{.color = color};
        scene.materials.push_back(material);
    }
    for (std::uint32_t t = 0; t < scene.index.size(); ++t) {
        Instance part;
        part.first_triangle = t;
        part.triangle_count = 1;
        part.material = std::uint32_t(t % colors.size());
        scene.owner[t] = t;
        scene.instances.push_back(part);
    }
    scene.background = {0.1f, 0.2f, 0.5f};
}

const View kView = straight_view(kSize, kSize, kSize);

/// A point that projects to (x, y) pixels from the picture's centre.
glm::vec3 point_at(float x, float y, float z)
{
    return {x * z / kSize, y * z / kSize, z};
}

TEST(Adaptive, HasTheBitsOfOneOrOfAllSamplesWhateverTheScene)
{
    AdaptiveCounts opaque, rest;
    for (const AdversarialScene& scene : adversarial_scenes()) {
        for (unsigned seed = 0; seed < 3; ++seed) {
            SCOPED_TRACE(scene.name + ", seed " + std::to_string(seed));
            std::mt19937 random(seed);
            TestWorld made;
            scene.fill(made, random);
            made.finish();
            if (seed == 0) {
                paint(made, {{1, 0.1f, 0}, {0, 0.8f, 0.1f}, {0.9f, 0.9f, 0.9f}});
            } else { // cut-outs, layers and textures, lit with shadows
                make_cutouts(made, random, seed == 1);
                made.world.lights = {point_light({0.5, -3, -1})};
                made.scene->background = {0.3f, 0.3f, 0.3f};
            }
            const AdaptiveCounts counts = count(made.world, kView, seed == 1 ? 3 : 4);
            EXPECT_EQ(counts.neither, 0u);
            (seed == 0 ? opaque : rest).add(counts);
        }
    }
    EXPECT_GT(opaque.needed, opaque.pixels / 10); // the scenes are hard
    EXPECT_LT(opaque.off, opaque.needed / 100) << opaque.off << " of " << opaque.needed;
    // In random textures, and behind what lets light through, more is missed.
    EXPECT_GT(rest.needed, rest.pixels / 10);
    EXPECT_LT(rest.off, rest.needed / 10) << rest.off << " of " << rest.needed;
}

TEST(Adaptive, FindsTrianglesThatNoCentreHits)
{
    // Each lies between the centres of two rows of pixels, or of two columns, and touches four pixels.
    TestWorld made;
    for (int k = 0; k < 40; ++k) {
        const float row = float(k / 8 * 8 - 16), column = float(k % 8 * 5 - 20), z = 2 + float(k);
        const bool upright = k % 2 == 1;
        const auto corner = [&](float along, float across) {
            return upright ? point_at(column + across, row + along, z)
                           : point_at(column + along, row + across, z);
        };
        made.add(corner(0.6f, 0.05f), corner(3.4f, 0.05f), corner(2, 0.3f));
    }
    made.finish();
    paint(made, {{1, 1, 1}, {1, 0.2f, 0}});
    const AdaptiveRun one = render_colors(made.world, kView, {});
    for (std::size_t k = 0; k < one.film.color.value.size(); k += 3)
        ASSERT_EQ(one.film.color.value[k], 0.1f) << "a centre hits";
    for (const int n : {2, 4, 5, 8}) {
        const AdaptiveCounts counts = count(made.world, kView, n);
        EXPECT_GE(counts.needed, 80u);
        EXPECT_EQ(counts.off, 0u) << n;
        EXPECT_EQ(counts.neither, 0u);
        EXPECT_LT(counts.fine, 400u);
    }
}

TEST(Adaptive, FindsAFarCheckerboardBeforeAWall)
{
    TestWorld made;
    made.add(point_at(-100, -100, 9), point_at(100, -100, 9), point_at(0, 120, 9));
    for (int k = 0; k < 60; ++k) { // less than a pixel, at random
        const float x = float(k * 37 % 41 - 20) + 0.1f * float(k % 9),
                    y = float(k * 23 % 43 - 21) + 0.1f * float(k % 7), z = 3 + float(k % 5);
        made.add(point_at(x, y, z), point_at(x + 0.4f, y, z), point_at(x, y + 0.4f, z));
    }
    made.finish();
    paint(made, {{0.7f, 0.7f, 0.7f}, {0, 0, 0}, {1, 0, 0}});
    const AdaptiveCounts counts = count(made.world, kView, 4);
    EXPECT_GT(counts.needed, 30u);
    EXPECT_EQ(counts.off, 0u);
    EXPECT_LT(counts.fine, 500u);
}

TEST(Adaptive, LeavesWhatIsHiddenOrOneSurfaceAlone)
{
    // A fine flat grid before another one: no edge but its border, which is outside the picture.
    TestWorld made;
    for (const float z : {2.0f, 5.0f})
        for (int j = -30; j < 30; ++j)
            for (int i = -30; i < 30; ++i) {
                const float x = 0.93f * float(i), y = 0.97f * float(j), s = z == 2.0f ? 1.0f : 0.3f;
                const auto corner = [&](float dx, float dy) {
                    return point_at(x + dx * 0.93f * s, y + dy * 0.97f * s, z);
                };
                made.add(corner(0, 0), corner(1, 0), corner(1, 1));
                made.add(corner(0, 0), corner(1, 1), corner(0, 1));
            }
    made.finish();
    made.world.lights = {directional_light({0, 0, 1})};
    const AdaptiveRun run = render_colors(made.world, kView, adaptive(4));
    EXPECT_EQ(run.stats.fine_pixels, 0u);
}

TEST(Adaptive, FindsTheBordersOfShadows)
{
    TestWorld made;
    made.add(point_at(-200, -200, 8), point_at(200, -200, 8), point_at(0, 300, 8));
    made.add({-0.5f, -2.2f, 4}, {0.6f, -2.0f, 4.4f}, {0.1f, -1.6f, 5});
    made.finish();
    made.world.lights = {point_light({0.3, -6, 1})};
    for (const Shadows shadows : {Shadows::exact, Shadows::none}) {
        Settings base;
        base.shadows = shadows;
        const AdaptiveCounts counts = count(made.world, kView, 4, base);
        EXPECT_GT(counts.needed, 20u);
        EXPECT_LE(counts.off, 1u); // the tip of the shadow, which no centre sees
        EXPECT_EQ(counts.neither, 0u);
        EXPECT_LT(counts.fine, counts.pixels / 4);
    }
}

TEST(Adaptive, LeavesPlanesThoseOfOneSample)
{
    Renderer renderer(1);
    const Scene scene = load_scene("builtin:robots");
    World world;
    renderer.pose(std::make_shared<const Scene>(scene), 2.5, world);
    View view;
    view.camera = world.camera;
    view.width = 90, view.height = 60;
    Settings settings = adaptive(4);
    settings.aovs = {Aov::item, Aov::depth, Aov::normal, Aov::lit, Aov::instance, Aov::position};
    Settings one = settings;
    one.adaptive = 1;
    const AdaptiveRun found = render_colors(world, view, settings),
                      expected = render_colors(world, view, one);
    EXPECT_EQ(found.film.item, expected.film.item);
    EXPECT_EQ(found.film.instance, expected.film.instance);
    for (std::size_t k = 0; k < found.film.aov.size(); ++k)
        EXPECT_EQ(found.film.aov[k].value, expected.film.aov[k].value) << k;
    EXPECT_NE(found.film.color.value, expected.film.color.value);
    settings.color = false; // nothing to do
    EXPECT_EQ(render_colors(world, view, settings).stats.fine_pixels, 0u);
}

/// A scene of the readers, with its own camera or a quarter view.
struct AdaptiveScene {
    World world;
    View view;
};

AdaptiveScene quarter_view(const std::string& name, double time_s, int width, int height)
{
    AdaptiveScene result;
    Renderer renderer(1);
    renderer.pose(std::make_shared<const Scene>(load_scene(name)), time_s, result.world);
    Framing framing = named_view(NamedView::iso, {0, 1, 0});
    framing.aspect = double(width) / height;
    const bool has_camera = !result.world.scene->cameras.empty();
    result.view.camera = has_camera ? result.world.camera : framing_camera(result.world, framing);
    result.view.width = width, result.view.height = height;
    return result;
}

TEST(Adaptive, DependsOnNeitherThreadsNorTilesNorFramesBefore)
{
    const AdaptiveScene scene = quarter_view("builtin:robots", 2.5, 201, 133);
    const Film expected = render_colors(scene.world, scene.view, adaptive(4)).film;
    Renderer renderer(3);
    for (const int tile_size : {8, 24, 64, 128}) {
        Settings settings = adaptive(4);
        settings.tile_size = tile_size;
        Film film;
        renderer.render(scene.world, scene.view, settings, film);
        EXPECT_EQ(film.color.value, expected.color.value) << tile_size;
        View small = scene.view; // something else in between
        small.width = 50, small.height = 70;
        renderer.render(scene.world, small, adaptive(2), film);
    }
}

TEST(Adaptive, OfARegionIsAPartOfTheWholePicture)
{
    const AdaptiveScene scene = quarter_view("builtin:robots", 2.5, 140, 100);
    std::mt19937 random(6);
    TestWorld layered;
    adversarial_scenes()[1].fill(layered, random);
    layered.finish();
    make_cutouts(layered, random, true);
    layered.world.lights = {point_light({0.5, -3, -1})};
    for (const auto& [world, view] : {std::pair{&std::as_const(scene.world), scene.view},
             std::pair{&std::as_const(layered.world), kView}}) {
        const Film whole = render_colors(*world, view, adaptive(4)).film;
        for (const Region region : {Region{7, 9, 31, 30}, Region{0, 0, 8, 8}, Region{17, 40, 1, 1},
                 Region{30, 0, 18, 48}}) {
            View part_view = view;
            part_view.region = region;
            Settings settings = adaptive(4);
            settings.aovs = {Aov::item, Aov::depth};
            const Film part = render_colors(*world, part_view, settings).film;
            ASSERT_EQ(part.color.value.size(), std::size_t(3 * region.width * region.height));
            ASSERT_EQ(part.item.size(), std::size_t(region.width * region.height));
            for (int y = 0; y < region.height; ++y)
                EXPECT_EQ(
                    0, std::memcmp(&part.color.value[std::size_t(3 * y * region.width)],
                           &whole.color
                                .value[std::size_t(3 * ((region.y + y) * whole.width + region.x))],
                           12 * std::size_t(region.width)))
                    << region.x << " " << region.y << " row " << y;
        }
    }
}

TEST(Adaptive, OfUsualScenesDiffersFromAllSamplesAtFewPixels)
{
    const auto check = [](const std::string& name, double bound) {
        const AdaptiveScene scene = quarter_view(name, 0, 400, 240);
        const AdaptiveCounts counts = count(scene.world, scene.view, 4);
        EXPECT_EQ(counts.neither, 0u);
        EXPECT_GT(counts.needed, counts.pixels / 200) << name;
        EXPECT_LE(double(counts.off), bound * double(counts.pixels)) << name << " " << counts.off;
        EXPECT_LT(counts.fine, counts.pixels / 5) << name;
    };
    check("builtin:torus", 0.0002);
    if (const auto helmet = test_data("gltf/FlightHelmet/FlightHelmet.gltf"))
        check(helmet->string(), 0.0005);
    if (const auto man = test_data("gltf/CesiumMan.glb")) check(man->string(), 0.003); // textures
}

TEST(Adaptive, RefusesNumbersThatItDoesNotTake)
{
    TestWorld made;
    made.add({0, 0, 2}, {1, 0, 2}, {0, 1, 2});
    made.finish();
    const auto message = [&](const Settings& settings) {
        return message_of<ArgumentError>([&] { (void)render_colors(made.world, kView, settings); });
    };
    EXPECT_EQ(message(adaptive(0)), "0 adaptive samples is out of range: 1 to 16");
    EXPECT_EQ(message(adaptive(17)), "17 adaptive samples is out of range: 1 to 16");
    Settings both = everywhere(2);
    both.adaptive = 3;
    EXPECT_EQ(message(both), "3 adaptive samples need 1 sample everywhere else, not 2");
    Settings sparse = adaptive(4);
    sparse.interleave = 2;
    EXPECT_EQ(message(sparse),
        "4 adaptive samples need a ray in each pixel, that is interleave 1, not 2");
    EXPECT_NO_THROW(render_colors(made.world, kView, adaptive(16)));
}

} // namespace
} // namespace firsthit::test
