// orthographic_test.cpp - pictures of orthographic cameras, against world space in long double, and against
// the pictures of pinhole cameras that are far away.
#include "message_of.h"
#include "scenes.h"

#include <firsthit/compare.h>
#include <firsthit/error.h>
#include <firsthit/framing.h>
#include <firsthit/render.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace firsthit::test {
namespace {

using Real = long double;

World posed_at(Scene scene, double time_s)
{
    World world;
    pose(std::move(scene), time_s, world);
    return world;
}

using Vector = glm::vec<3, Real>;

/// The rays of an orthographic camera, by the words of firsthit/view.h.
struct ParallelRays {
    Vector eye, right, down, forward;
    Real step;
    int width, height;

    explicit ParallelRays(const View& view)
        : eye(view.camera.eye),
          step(Real(*view.camera.orthographic_height) / view.height),
          width(view.width),
          height(view.height)
    {
        forward = glm::normalize(Vector(view.camera.direction));
        right = glm::normalize(glm::cross(forward, Vector(view.camera.up)));
        down = glm::cross(forward, right);
    }

    Vector start(int x, int y) const
    {
        return eye + right * ((Real(x) + Real(0.5) - Real(width) / 2) * step) +
               down * ((Real(y) + Real(0.5) - Real(height) / 2) * step);
    }
};

/// Where a ray meets a triangle. slack: how far the weights are from the triangle's border.
struct Met {
    Real t = 0, u = 0, v = 0, slack = -1;
};

Met meet(const World& world, std::size_t triangle, const Vector& from, const Vector& along)
{
    const glm::uvec3& c = world.scene->index[triangle];
    const Vector p0(world.position[c.x]), e1 = Vector(world.position[c.y]) - p0,
                                          e2 = Vector(world.position[c.z]) - p0;
    const Vector p = glm::cross(along, e2), s = from - p0, q = glm::cross(s, e1);
    const Real det = glm::dot(e1, p);
    if (det == 0) return {};
    Met met;
    met.u = glm::dot(s, p) / det;
    met.v = glm::dot(along, q) / det;
    met.t = glm::dot(e2, q) / det;
    met.slack = std::min({met.u, met.v, 1 - met.u - met.v});
    return met;
}

void add_random_triangles(TestWorld& world, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> at(-1, 1), size(-0.4f, 0.4f);
    for (int k = 0; k < 60; ++k) {
        const glm::vec3 p(at(random), at(random), at(random));
        const auto corner = [&] { return p + glm::vec3(size(random), size(random), size(random)); };
        const glm::vec3 a = corner(), b = corner();
        world.add(a, b, corner());
    }
    world.finish();
}

View oblique_view()
{
    View view;
    view.width = 90, view.height = 70;
    view.camera.eye = {2, 1.5, 2.5};
    view.camera.direction = {-2, -1.4, -2.6};
    view.camera.orthographic_height = 2.2;
    return view;
}

Film render_planes(const World& world, const View& view, const Settings& settings = {})
{
    Settings own = settings;
    own.color = false;
    own.aovs = {Aov::item, Aov::depth, Aov::distance, Aov::barycentric, Aov::position,
        Aov::position_camera};
    Film film;
    Renderer(2).render(world, view, own, film);
    return film;
}

/// Compares all planes with the oracle. Returns how many pixels were certain enough to be compared.
std::size_t check_planes(const World& world, const View& view)
{
    const Film film = render_planes(world, view);
    const ParallelRays rays(view);
    std::size_t compared = 0;
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            const std::size_t k = std::size_t(y) * std::size_t(view.width) + std::size_t(x);
            std::uint32_t nearest = kNoItem;
            Met best;
            best.t = std::numeric_limits<Real>::infinity();
            bool certain = true;
            for (std::size_t t = 0; t < world.scene->index.size(); ++t) {
                const Met met = meet(world, t, rays.start(x, y), rays.forward);
                certain = certain && !(std::abs(met.slack) < 1e-3L && met.t > 0);
                certain = certain && !(met.slack > 0 && std::abs(met.t) < 1e-4L);
                if (!(met.slack > 0) || !(met.t > 0)) continue;
                certain = certain && std::abs(met.t - best.t) > 1e-4L;
                if (met.t < best.t) best = met, nearest = std::uint32_t(t);
            }
            if (!certain) continue;
            ++compared;
            EXPECT_EQ(film.item[k], nearest) << x << " " << y;
            if (nearest == kNoItem || film.item[k] != nearest) continue;
            const float* const weight = &film[Aov::barycentric].value[2 * k];
            EXPECT_NEAR(film[Aov::depth].value[k], double(best.t), 2e-6);
            EXPECT_EQ(film[Aov::distance].value[k], film[Aov::depth].value[k]);
            EXPECT_NEAR(weight[0], double(best.u), 1e-4);
            EXPECT_NEAR(weight[1], double(best.v), 1e-4);
            const Vector seen = rays.start(x, y) + best.t * rays.forward;
            const Vector offset = rays.start(x, y) - rays.eye;
            const Vector camera(glm::dot(offset, rays.right), glm::dot(offset, rays.down), best.t);
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_NEAR(
                    film[Aov::position].value[3 * k + std::size_t(axis)], double(seen[axis]), 4e-6);
                EXPECT_NEAR(film[Aov::position_camera].value[3 * k + std::size_t(axis)],
                    double(camera[axis]), 4e-6);
            }
        }
    }
    return compared;
}

TEST(Orthographic, PlanesAreThoseOfParallelRays)
{
    for (unsigned seed = 0; seed < 4; ++seed) {
        TestWorld world;
        add_random_triangles(world, seed);
        EXPECT_GT(check_planes(world.world, oblique_view()), 5000u);
    }
}

TEST(Orthographic, WhatIsBehindTheEyeIsNotSeen)
{
    for (unsigned seed = 10; seed < 14; ++seed) {
        TestWorld world;
        add_random_triangles(world, seed);
        View view = oblique_view();
        view.camera.eye = {0.1, -0.05, 0.02}; // amid the triangles, of which it cuts many
        EXPECT_GT(check_planes(world.world, view), 5000u);
        view.camera.eye = {-2, -1.4, -2.6}; // all are behind it
        for (const std::uint32_t item : render_planes(world.world, view).item)
            ASSERT_EQ(item, kNoItem);
    }
}

TEST(Orthographic, APlaneThroughTheEyeHidesNothing)
{
    // The floor lies exactly in the plane that the rays start in.
    TestWorld world;
    world.add({-9, 0, -9}, {9, 0, -9}, {0, 0, 9});
    world.add({-9, -1, -9}, {9, -1, -9}, {0, -1, 9});
    world.finish();
    View view;
    view.width = view.height = 16;
    view.camera.eye = {0, 0, 0};
    view.camera.direction = {0, -1, 0};
    view.camera.up = {0, 0, -1};
    view.camera.orthographic_height = 2;
    for (const std::uint32_t item : render_planes(world.world, view).item) ASSERT_EQ(item, 1u);
}

/// A pinhole camera that sees what an orthographic one sees, from so far away that its rays are nearly
/// parallel.
View seen_from_afar(View view, double away)
{
    Camera& camera = view.camera;
    const glm::dvec3 forward = glm::normalize(camera.direction);
    camera.eye -= forward * away;
    camera.fov_y_rad = 2 * std::atan(0.5 * *camera.orthographic_height / away);
    camera.orthographic_height.reset();
    return view;
}

/// The share of pixels whose colours differ by more than `most`.
double share_that_differs(const Film& a, const Film& b, float most)
{
    std::size_t count = 0;
    const std::size_t pixels = a.color.value.size() / 3;
    for (std::size_t k = 0; k < pixels; ++k) {
        bool differs = false;
        for (std::size_t c = 0; c < 3; ++c)
            differs =
                differs || !(std::abs(a.color.value[3 * k + c] - b.color.value[3 * k + c]) <= most);
        count += differs;
    }
    return double(count) / double(pixels);
}

class Colors : public testing::TestWithParam<Shadows> {};

TEST_P(Colors, AreThoseOfAFarPinholeCamera)
{
    Renderer renderer(2);
    for (const char* name : {"builtin:robots", "builtin:torus"}) {
        const World world = posed_at(load_scene(name), 2.5);
        Framing framing = named_view(NamedView::iso, {0, 1, 0});
        framing.orthographic = true;
        View view;
        view.width = 160, view.height = 120;
        framing.aspect = 160.0 / 120;
        view.camera = framing_camera(world, framing);
        Settings settings;
        settings.shadows = GetParam();
        settings.sky.directions = GetParam() == Shadows::exact ? 16 : 0;
        for (const int samples : {1, 2}) {
            settings.samples = samples;
            Film parallel, pinhole;
            renderer.render(world, view, settings, parallel);
            const double scale = *view.camera.orthographic_height;
            renderer.render(world, seen_from_afar(view, 3000 * scale), settings, pinhole);
            // Edges move by a fraction of a pixel, and a sample at them sees another colour.
            EXPECT_LT(share_that_differs(parallel, pinhole, 0.03f), 0.02) << name << samples;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Orthographic, Colors, testing::Values(Shadows::none, Shadows::map, Shadows::exact));

TEST(Orthographic, AdaptiveSamplesAreThoseOfAllPixels)
{
    const World world = posed_at(load_scene("builtin:robots"), 1);
    Framing framing = named_view(NamedView::iso, {0, 1, 0});
    framing.orthographic = true;
    View view;
    view.width = view.height = 128;
    view.camera = framing_camera(world, framing);
    Settings settings;
    settings.shadows = Shadows::none;
    settings.sky.directions = 0;
    Renderer renderer(2);
    Film coarse, adaptive, full;
    renderer.render(world, view, settings, coarse);
    settings.adaptive = 4;
    renderer.render(world, view, settings, adaptive);
    settings.adaptive = 1;
    settings.samples = 4;
    renderer.render(world, view, settings, full);
    std::size_t sampled = 0;
    for (std::size_t k = 0; k < full.color.value.size(); ++k) {
        const float a = adaptive.color.value[k];
        EXPECT_TRUE(a == full.color.value[k] || a == coarse.color.value[k]) << k;
        sampled += a != coarse.color.value[k];
    }
    EXPECT_GT(sampled, 1000u);
    EXPECT_LT(share_that_differs(adaptive, full, 0.02f), 0.004);
}

TEST(Orthographic, ItemsAndShadowsEqualBruteForce)
{
    const World world = posed_at(load_scene("builtin:robots"), 4);
    for (const bool inside : {false, true}) {
        Framing framing = named_view(NamedView::iso, {0, 1, 0});
        framing.orthographic = true;
        View view;
        view.width = view.height = 96;
        view.camera = framing_camera(world, framing);
        if (inside) view.camera.eye = glm::dvec3(bounds(world)[0] + bounds(world)[1]) * 0.5;
        EXPECT_EQ(compare(world, view, Oracle::brute, 2).ours_wrong, 0u);
        const LitComparison lit = compare_lit(world, view, Oracle::brute, 2);
        EXPECT_EQ(lit.ours_wrong, 0u);
        EXPECT_GT(lit.agree, 1000u);
    }
}

TEST(Orthographic, RegionsThreadsAndInterleavingHaveTheSameBits)
{
    const World world = posed_at(load_scene("builtin:robots"), 4);
    Framing framing = named_view(NamedView::iso, {0, 1, 0});
    framing.orthographic = true;
    View view;
    view.width = 200, view.height = 150;
    framing.aspect = 200.0 / 150;
    view.camera = framing_camera(world, framing);
    Settings settings;
    settings.shadows = Shadows::exact;
    settings.sky.directions = 0;
    Film whole, part, steps;
    Renderer(2).render(world, view, settings, whole);
    const auto at = [](const Film& film, int x, int y) {
        const std::size_t k = 3 * (std::size_t(y) * std::size_t(film.width) + std::size_t(x));
        return glm::vec3(film.color.value[k], film.color.value[k + 1], film.color.value[k + 2]);
    };
    View region = view;
    region.region = {37, 21, 90, 80};
    Renderer(1).render(world, region, settings, part);
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 90; ++x) ASSERT_EQ(at(part, x, y), at(whole, x + 37, y + 21));
    settings.interleave = 4;
    Renderer(1).render(world, view, settings, steps);
    for (int y = 0; y < 150; y += 2)
        for (int x = 0; x < 200; x += 2) ASSERT_EQ(at(steps, x, y), at(whole, x, y));
}

TEST(Orthographic, SaysWhatIsWrong)
{
    TestWorld world;
    add_random_triangles(world, 1);
    Renderer renderer(1);
    Film film;
    Settings settings;
    const auto message = [&](const View& view) {
        return message_of<ArgumentError>(
            [&] { renderer.render(world.world, view, settings, film); });
    };
    View view = oblique_view();
    for (const double height : {0.0, -1.0, 1e13, std::nan("")}) {
        view.camera.orthographic_height = height;
        EXPECT_NE(message(view).find("orthographic height"), std::string::npos) << height;
    }
    view = oblique_view();
    view.camera.focal = glm::dvec2(100);
    EXPECT_NE(message(view).find("no focal lengths"), std::string::npos);
    view = oblique_view();
    for (const Engine engine : {Engine::hybrid, Engine::gpu}) {
        settings.engine = engine;
        EXPECT_NE(message(view).find("cpu engine"), std::string::npos);
    }
    settings.engine = Engine::automatic;
    renderer.render(world.world, view, settings, film);
    EXPECT_EQ(renderer.engine().engine, Engine::cpu);
}

} // namespace
} // namespace firsthit::test
