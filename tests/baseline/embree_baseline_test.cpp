// embree_baseline_test.cpp - the frame by Embree is the cpu engine's with exact shadows, but for a few pixels.
#include "lights.h"
#include "message_of.h"
#include "scene/model/borrow.h"

#include <firsthit/firsthit.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace firsthit::test {
namespace {

constexpr int kSize = 192;

std::vector<Aov> all_planes()
{
    std::vector<Aov> aovs;
    for (int k = 0; k < kAovCount; ++k) aovs.push_back(static_cast<Aov>(k));
    return aovs;
}

Settings settings()
{
    Settings asked;
    asked.shadows = Shadows::exact;
    asked.aovs = all_planes();
    return asked;
}

View view_of(const World& world, int width = kSize, int height = kSize)
{
    View view;
    view.width = width;
    view.height = height;
    view.camera = world.camera;
    return view;
}

Film ours(const Scene& scene, double time_s, const View& view)
{
    Renderer renderer(1);
    Film film;
    renderer.render(scene, time_s, view, settings(), film);
    return film;
}

/// Pixels that differ between two films: in their item; in their lights, of the same item; in another
/// plane, or the colour, of the same item and lights.
struct Differences {
    std::size_t pixels = 0, items = 0, lights = 0, values = 0;
};

/// How far a plane's values may be apart where nothing but roundings differs.
double tolerance(Aov aov, float value)
{
    switch (aov) {
    case Aov::item:
    case Aov::instance:
    case Aov::material:
    case Aov::node:
    case Aov::lit:
    case Aov::metallic_roughness:
    case Aov::emission:
    case Aov::motion:
    case Aov::motion_visible:
        return 0;
    case Aov::depth:
    case Aov::distance:
    case Aov::position:
    case Aov::position_camera:
        return 2e-3 * std::max(1.0, std::abs(double(value)));
    case Aov::uv:
    case Aov::normal:
    case Aov::normal_camera:
    case Aov::geometric_normal:
    case Aov::albedo:
    case Aov::barycentric:
    case Aov::tangent:
        break;
    }
    return 2e-2;
}

bool near(float a, float b, double most)
{
    return a == b || std::abs(double(a) - double(b)) <= most;
}

Differences differences(const Film& a, const Film& b)
{
    Differences found{.pixels = a.item.size()};
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.item.size(), b.item.size());
    if (a.item.size() != b.item.size()) return found;
    const std::size_t lights = std::size_t(a[Aov::lit].channels);
    for (std::size_t k = 0; k < a.item.size(); ++k) {
        if (a.item[k] != b.item[k]) {
            ++found.items;
            continue;
        }
        const auto lit = [&](const Film& film) {
            return film[Aov::lit].value.begin() + std::ptrdiff_t(k * lights);
        };
        if (!std::equal(lit(a), lit(a) + std::ptrdiff_t(lights), lit(b))) {
            ++found.lights;
            continue;
        }
        bool same = true;
        for (std::size_t c = 3 * k; c < 3 * k + 3; ++c)
            same &= near(a.color.value[c], b.color.value[c], 2e-2);
        for (const Aov aov : all_planes()) {
            if (aov == Aov::item) continue;
            const auto channels = std::size_t(a[aov].channels);
            for (std::size_t c = channels * k; c < channels * (k + 1); ++c)
                same &= near(a[aov].value[c], b[aov].value[c], tolerance(aov, a[aov].value[c]));
        }
        found.values += !same;
    }
    return found;
}

void expect_same(const Differences& found, const std::string& what)
{
    EXPECT_LE(found.items, 8u) << what;
    EXPECT_LE(found.lights, 60u) << what;
    EXPECT_LE(found.values, 8u) << what;
}

/// A cloth that every vertex moves of, two robots' worth of instances, a still torus, and a room with seven lights.
std::vector<std::pair<std::string, double>> scenes()
{
    return {{"builtin:torus", 0}, {"builtin:robots", 2.5}, {"builtin:wave?n=3000", 0.7},
        {"builtin:room", 5}};
}

class EmbreeBaselineTest : public testing::Test {
  protected:
    void SetUp() override
    {
        if (baseline_version().empty()) GTEST_SKIP() << "this build has no Embree";
    }
};

TEST_F(EmbreeBaselineTest, MakesTheCpuEnginesPicturesAndPlanes)
{
    for (const auto& [name, time_s] : scenes()) {
        const Scene scene = load_scene(name);
        for (const BaselineUpdate update : kBaselineUpdates)
            for (const int packet : {8, 16}) {
                EmbreeBaseline baseline(borrow(scene), update, 1, packet);
                const View view = view_of(baseline.pose(time_s));
                Film film;
                baseline.render(view, settings(), film);
                expect_same(differences(ours(scene, time_s, view), film),
                    name + ", " + std::string(baseline_update_name(update)) + ", " +
                        std::to_string(packet));
                EXPECT_EQ(baseline.stats().hits,
                    film.item.size() -
                        std::size_t(std::count(film.item.begin(), film.item.end(), kNoItem)));
                EXPECT_GT(baseline.stats().shadow_rays, 0u);
            }
    }
}

TEST_F(EmbreeBaselineTest, MakesTheCpuEnginesPicturesOfACalibratedCamera)
{
    const Scene scene = load_scene("builtin:robots");
    for (const int packet : {8, 16}) {
        EmbreeBaseline baseline(borrow(scene), BaselineUpdate::refit_instances, 1, packet);
        View view = view_of(baseline.pose(2.5), 120, 100);
        view.camera.focal = glm::dvec2(150.3, 97.1);
        view.camera.principal_point = glm::dvec2(50.37, 61.9);
        view.camera.skew = 17.3;
        Film film;
        baseline.render(view, settings(), film);
        expect_same(differences(ours(scene, 2.5, view), film), std::to_string(packet));
        EXPECT_GT(baseline.stats().shadow_rays, 1000u);
    }
}

TEST_F(EmbreeBaselineTest, KnowsEveryKindOfLightAndManyOfThem)
{
    Scene scene = load_scene("builtin:torus");
    scene.lights = {spot_light({2, 4, 3}, {-2, -4, -3}, 0.15, 0.5),
        directional_light({-1, -2, -0.5}), point_light({-3, 2, 1})};
    for (int k = 0; k < 17; ++k) scene.lights.push_back(point_light({0.3 * k - 2, 3, 2}));
    for (const int packet : {8, 16}) {
        EmbreeBaseline baseline(borrow(scene), BaselineUpdate::refit, 1, packet);
        const View view = view_of(baseline.pose(0));
        Film film;
        baseline.render(view, settings(), film);
        expect_same(differences(ours(scene, 0, view), film), "lights");
        // Every light reaches something, and not everything that is seen.
        for (std::size_t light = 0; light < scene.lights.size(); ++light) {
            std::size_t lit = 0;
            for (std::size_t k = 0; k < film.item.size(); ++k)
                lit += film[Aov::lit].value[k * scene.lights.size() + light] > 0;
            EXPECT_GT(lit, 0u) << light;
            EXPECT_LT(lit, baseline.stats().hits) << light;
        }
    }
}

TEST_F(EmbreeBaselineTest, AWrongLightIsNoticed)
{
    const Scene scene = load_scene("builtin:torus");
    Scene wrong = scene;
    wrong.lights.at(0).position += glm::dvec3(0.3, 0, 0);
    EmbreeBaseline baseline(borrow(wrong), BaselineUpdate::refit, 1);
    const View view = view_of(baseline.pose(0));
    Film film;
    baseline.render(view, settings(), film);
    const Differences found = differences(ours(scene, 0, view), film);
    EXPECT_EQ(found.items, 0u);
    EXPECT_GT(found.lights + found.values, found.pixels / 100);
}

TEST_F(EmbreeBaselineTest, FollowsWhatMovesFromFrameToFrame)
{
    for (const char* const name : {"builtin:wave?n=3000", "builtin:robots"}) {
        const Scene scene = load_scene(name);
        for (const BaselineUpdate update : kBaselineUpdates) {
            EmbreeBaseline baseline(borrow(scene), update, 1);
            Film film, before;
            const View view = view_of(baseline.pose(0));
            baseline.render(view, settings(), before);
            for (const double time_s : {0.5, 1.3}) {
                baseline.pose(time_s);
                baseline.render(view, settings(), film);
                const Film expected = ours(scene, time_s, view);
                expect_same(differences(expected, film), name);
                // A tree that had stayed behind would be seen.
                EXPECT_GT(differences(expected, before).items, film.item.size() / 200) << name;
            }
        }
    }
}

TEST_F(EmbreeBaselineTest, PicturesMayEndInsideOfATileAndBeRegions)
{
    const Scene scene = load_scene("builtin:robots");
    for (const int packet : {8, 16}) {
        EmbreeBaseline baseline(borrow(scene), BaselineUpdate::refit, 1, packet);
        View view = view_of(baseline.pose(1), 101, 67);
        Film film;
        baseline.render(view, settings(), film);
        expect_same(differences(ours(scene, 1, view), film), "101x67");
        view.region = {13, 7, 75, 51};
        baseline.render(view, settings(), film);
        EXPECT_EQ(film.width, 75);
        expect_same(differences(ours(scene, 1, view), film), "region");
    }
}

TEST_F(EmbreeBaselineTest, ThreadsDoNotChangeThePicture)
{
    const Scene scene = load_scene("builtin:robots");
    EmbreeBaseline one(borrow(scene), BaselineUpdate::refit, 1),
        two(borrow(scene), BaselineUpdate::refit, 2);
    const View view = view_of(one.pose(1));
    two.pose(1);
    Film a, b;
    one.render(view, settings(), a);
    two.render(view, settings(), b);
    EXPECT_EQ(a.item, b.item);
    EXPECT_EQ(a.color.value, b.color.value);
}

TEST_F(EmbreeBaselineTest, WithoutShadowsEveryLightReachesEverything)
{
    const Scene scene = load_scene("builtin:torus");
    EmbreeBaseline baseline(borrow(scene), BaselineUpdate::refit, 1);
    const View view = view_of(baseline.pose(0));
    Settings none = settings();
    none.shadows = Shadows::none;
    Film film, expected;
    baseline.render(view, none, film);
    EXPECT_EQ(baseline.stats().shadow_rays, 0u);
    Renderer(1).render(scene, 0, view, none, expected);
    expect_same(differences(expected, film), "none");
}

TEST_F(EmbreeBaselineTest, UpdatesWhatHasMovedOrIsAssumedToHaveMoved)
{
    const Scene still = load_scene("builtin:torus"), robots = load_scene("builtin:robots");
    EmbreeBaseline torus(borrow(still), BaselineUpdate::refit, 1);
    const auto updated = [](EmbreeBaseline& baseline, double time_s) {
        View view;
        view.width = view.height = 8;
        view.camera = framing_camera(baseline.pose(time_s));
        Film film;
        baseline.render(view, settings(), film);
        return baseline.stats().updated_triangles;
    };
    EXPECT_EQ(updated(torus, 0), still.triangle_count());
    EXPECT_EQ(updated(torus, 1), 0u);
    torus.assume_moved();
    EXPECT_EQ(updated(torus, 1), still.triangle_count());
    // Robots walk; the floor does not.
    EmbreeBaseline whole(borrow(robots), BaselineUpdate::refit, 1),
        instances(borrow(robots), BaselineUpdate::refit_instances, 1);
    for (EmbreeBaseline* baseline : {&whole, &instances}) updated(*baseline, 1);
    EXPECT_EQ(updated(whole, 1.1), robots.triangle_count());
    EXPECT_GT(updated(instances, 1.1), 0u);
    EXPECT_LT(instances.stats().updated_triangles, robots.triangle_count());
}

TEST_F(EmbreeBaselineTest, AnEmptySceneIsItsBackground)
{
    Scene scene = scene_from_arrays({}, {});
    scene.background = {0.25f, 0.5f, 1};
    EmbreeBaseline baseline(borrow(scene), BaselineUpdate::refit_instances, 1);
    View view;
    view.width = view.height = 20;
    Film film;
    baseline.render(view, settings(), film);
    EXPECT_EQ(std::count(film.item.begin(), film.item.end(), kNoItem), 400);
    EXPECT_EQ(film.color.value[5], 1);
    EXPECT_EQ(baseline.stats().hits, 0u);
}

TEST_F(EmbreeBaselineTest, RefusesWhatItDoesNotMake)
{
    const Scene scene = load_scene("builtin:torus");
    EXPECT_NE(message_of<ArgumentError>([&] {
        EmbreeBaseline(borrow(scene), BaselineUpdate::refit, 1, 4);
    }).find("8 or 16 rays, not 4"),
        std::string::npos);
    EmbreeBaseline baseline(borrow(scene), BaselineUpdate::refit, 1);
    Film film;
    const auto refusal = [&](auto change) {
        Settings asked;
        change(asked);
        return message_of<ArgumentError>([&] { baseline.render(View(), asked, film); });
    };
    EXPECT_NE(
        refusal([](Settings& s) { s.samples = 2; }).find("one ray a pixel"), std::string::npos);
    EXPECT_NE(
        refusal([](Settings& s) { s.interleave = 2; }).find("one ray a pixel"), std::string::npos);
    EXPECT_NE(refusal([](Settings& s) { s.shadows = Shadows::map; }).find("no shadow maps"),
        std::string::npos);
    EXPECT_NE(refusal([](Settings& s) { s.tile_size = 7; }).find("tile size 7"), std::string::npos);
}

TEST(EmbreeBaseline, IsADeviceErrorWhereTheBuildHasNone)
{
    if (!baseline_version().empty()) GTEST_SKIP() << "this build has " << baseline_version();
    const Scene scene = load_scene("builtin:torus");
    EXPECT_NE(message_of<DeviceError>([&] {
        EmbreeBaseline(borrow(scene), BaselineUpdate::refit);
    }).find("FIRSTHIT_BUILD_EMBREE=OFF"),
        std::string::npos);
}

} // namespace
} // namespace firsthit::test
