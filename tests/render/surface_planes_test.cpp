// surface_planes_test.cpp - the planes tangent, metallic_roughness, emission, motion, motion_visible.
#include "message_of.h"
#include "scenes.h"

#include <firsthit/firsthit.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace firsthit::test {
namespace {

Film render(const World& world, const View& view, const PreviousFrame& previous,
    std::vector<Aov> aovs = {Aov::motion, Aov::motion_visible, Aov::item, Aov::barycentric})
{
    Settings settings;
    settings.color = false;
    settings.aovs = std::move(aovs);
    settings.previous = previous;
    Film film;
    Renderer(2).render(world, view, settings, film);
    return film;
}

/// A square of half width 3 that faces the eye of straight_view.
TestWorld plate(const glm::vec3& middle)
{
    TestWorld made;
    const glm::vec3 x(3, 0, 0), y(0, 3, 0);
    made.add(middle - x - y, middle + x - y, middle + x + y);
    made.add(middle - x - y, middle + x + y, middle - x + y);
    made.finish();
    return made;
}

TEST(Motion, OfAPlateThatMovesIsThatOfItsPoints)
{
    const glm::vec3 moved(0.5f, -0.25f, 1.0f);
    const TestWorld now = plate({0, 0, 10}), before = plate(glm::vec3(0, 0, 10) - moved);
    const double f = 40;
    const View view = straight_view(64, 48, f);
    const Film film = render(now.world, view, {&before.world, view.camera});
    int hits = 0;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            const auto k = std::size_t(y * 64 + x);
            const float* const motion = &film[Aov::motion].value[2 * k];
            if (film.item[k] == kNoItem) {
                EXPECT_EQ(motion[0], 0);
                EXPECT_EQ(film[Aov::motion_visible].value[k], 0);
                continue;
            }
            ++hits;
            const glm::dvec3 point((x + 0.5 - 32) / f * 10, (y + 0.5 - 24) / f * 10, 10);
            const glm::dvec3 then = point - glm::dvec3(moved);
            EXPECT_NEAR(motion[0], x + 0.5 - (f * then.x / then.z + 32), 2e-4);
            EXPECT_NEAR(motion[1], y + 0.5 - (f * then.y / then.z + 24), 2e-4);
            EXPECT_EQ(film[Aov::motion_visible].value[k], 1);
        }
    EXPECT_GT(hits, 400);
}

TEST(Motion, OfACameraThatMovesAndOfWhatLeavesItsPicture)
{
    const TestWorld world = plate({0, 0, 10});
    const View view = straight_view(64, 48, 80);
    Camera before = view.camera;
    before.eye.x = 2; // the plate was farther left by 80 * 2 / 10 pixels
    const Film film = render(world.world, view, {&world.world, before});
    int left = 0;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
            const auto k = std::size_t(y * 64 + x);
            if (film.item[k] == kNoItem) continue;
            EXPECT_NEAR(film[Aov::motion].value[2 * k], 16, 1e-4);
            EXPECT_NEAR(film[Aov::motion].value[2 * k + 1], 0, 1e-4);
            const bool was_seen = x + 0.5 - 16 >= 0;
            EXPECT_EQ(film[Aov::motion_visible].value[k], was_seen) << x << " " << y;
            left += !was_seen;
        }
    EXPECT_GT(left, 100);
}

TEST(Motion, IsExactlyNoneWhereNothingMovesAndWithoutAFrameBefore)
{
    const TestWorld world = plate({0.3f, 0.1f, 7});
    const View view = straight_view(64, 48, 60);
    for (const PreviousFrame& previous :
        {PreviousFrame{}, PreviousFrame{&world.world, view.camera}}) {
        const Film film = render(world.world, view, previous);
        for (std::size_t k = 0; k < film.item.size(); ++k) {
            EXPECT_EQ(film[Aov::motion].value[2 * k], 0);
            EXPECT_EQ(film[Aov::motion].value[2 * k + 1], 0);
            EXPECT_EQ(film[Aov::motion_visible].value[k], film.item[k] != kNoItem);
        }
    }
}

/// Where the segment from `a` to `b` meets a triangle, as a share of its length; infinite: nowhere. `edge`
/// becomes how near to an edge, as a share of the triangle.
double meet(const World& world, std::uint32_t triangle, const glm::dvec3& a, const glm::dvec3& b,
    double& edge)
{
    const glm::uvec3& corner = world.scene->index[triangle];
    const glm::dvec3 p(world.position[corner.x]);
    const glm::dvec3 e1 = glm::dvec3(world.position[corner.y]) - p;
    const glm::dvec3 e2 = glm::dvec3(world.position[corner.z]) - p;
    const glm::dvec3 n = glm::cross(e1, e2), d = b - a;
    const double along = glm::dot(n, d);
    const double t = glm::dot(n, p - a) / along;
    const glm::dvec3 at = a + t * d - p;
    const double u = glm::dot(glm::cross(at, e2), n) / glm::dot(n, n);
    const double v = glm::dot(glm::cross(e1, at), n) / glm::dot(n, n);
    edge = std::min({std::abs(u), std::abs(v), std::abs(1 - u - v)});
    const bool inside = u >= 0 && v >= 0 && u + v <= 1 && t > 0;
    return inside ? t : std::numeric_limits<double>::infinity();
}

TEST(Motion, IsVisibleWhereNoTriangleWasBeforeThePoint)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> number(-1, 1);
    const auto point = [&](float size) {
        const float x = number(random), y = number(random), z = number(random);
        return size * glm::vec3(x, y, z);
    };
    TestWorld now, before;
    for (int k = 0; k < 60; ++k) {
        const glm::vec3 middle = point(5) + glm::vec3(0, 0, 12), moved = point(0.8f);
        const glm::vec3 a = middle + point(2), b = middle + point(2), c = middle + point(2);
        now.add(a, b, c);
        before.add(a + moved, b + moved + point(0.1f), c + moved);
    }
    now.finish(), before.finish();
    const View view = straight_view(96, 72, 70);
    Camera camera = view.camera;
    camera.eye = {0.7, -0.3, 0.5};
    const Film film = render(now.world, view, {&before.world, camera});
    int hidden = 0, seen = 0, unsure = 0;
    for (std::size_t k = 0; k < film.item.size(); ++k) {
        if (film.item[k] == kNoItem) continue;
        const glm::uvec3& corner = now.scene->index[film.item[k]];
        const float u = film[Aov::barycentric].value[2 * k];
        const float v = film[Aov::barycentric].value[2 * k + 1];
        const auto& position = before.world.position;
        const glm::dvec3 then = (1.0 - u - v) * glm::dvec3(position[corner.x]) +
                                double(u) * glm::dvec3(position[corner.y]) +
                                double(v) * glm::dvec3(position[corner.z]);
        const glm::dvec3 from_eye = then - camera.eye;
        const double x = 70 * from_eye.x / from_eye.z + 48, y = 70 * from_eye.y / from_eye.z + 36;
        EXPECT_NEAR(film[Aov::motion].value[2 * k], double(k % 96) + 0.5 - x, 1e-3);
        EXPECT_NEAR(film[Aov::motion].value[2 * k + 1], double(k / 96) + 0.5 - y, 1e-3);
        bool visible = x >= 0 && x < 96 && y >= 0 && y < 72, sure = true;
        for (std::uint32_t triangle = 0; triangle < 60; ++triangle) {
            if (triangle == film.item[k]) continue;
            double edge = 1;
            const double t = meet(before.world, triangle, camera.eye, then, edge);
            sure = sure && edge > 1e-4 && std::abs(t - 1) > 1e-4;
            visible = visible && !(t < 1);
        }
        if (!sure) {
            ++unsure;
            continue;
        }
        EXPECT_EQ(film[Aov::motion_visible].value[k], visible) << k;
        ++(visible ? seen : hidden);
    }
    EXPECT_GT(seen, 500);
    EXPECT_GT(hidden, 300);
    EXPECT_LT(unsure, 100);
}

TEST(Motion, OfAnimatedScenesIsThatOfTheirPoses)
{
    const auto scene = std::make_shared<const Scene>(load_scene("builtin:robots"));
    World now, before;
    pose(scene, 1.5, now);
    pose(scene, 1.4, before);
    View view;
    view.camera = now.camera, view.width = 160, view.height = 120;
    const Film film = render(now, view, {&before, before.camera});
    const double f = 60 / std::tan(0.5 * before.camera.fov_y_rad);
    const glm::dvec3 z = glm::normalize(before.camera.direction);
    const glm::dvec3 x = glm::normalize(glm::cross(z, before.camera.up)), y = glm::cross(z, x);
    double most = 0;
    for (std::size_t k = 0; k < film.item.size(); ++k) {
        if (film.item[k] == kNoItem) continue;
        const glm::uvec3& corner = scene->index[film.item[k]];
        const double u = film[Aov::barycentric].value[2 * k];
        const double v = film[Aov::barycentric].value[2 * k + 1];
        const glm::dvec3 then = (1 - u - v) * glm::dvec3(before.position[corner.x]) +
                                u * glm::dvec3(before.position[corner.y]) +
                                v * glm::dvec3(before.position[corner.z]) - before.camera.eye;
        if (glm::dot(then, z) <= 0) continue;
        const double depth = glm::dot(then, z);
        const double column = f * glm::dot(then, x) / depth + 80;
        const double row = f * glm::dot(then, y) / depth + 60;
        EXPECT_NEAR(film[Aov::motion].value[2 * k], double(k % 160) + 0.5 - column, 0.01);
        EXPECT_NEAR(film[Aov::motion].value[2 * k + 1], double(k / 160) + 0.5 - row, 0.01);
        most = std::max(most, double(std::abs(film[Aov::motion].value[2 * k])));
    }
    EXPECT_GT(most, 0.5);
}

TEST(Motion, RefusesAFrameOfAnotherScene)
{
    const TestWorld world = plate({0, 0, 10});
    TestWorld other;
    other.add({0, 0, 1}, {1, 0, 1}, {0, 1, 1});
    other.finish();
    const View view = straight_view(16, 16, 10);
    EXPECT_NE(message_of<ArgumentError>([&] {
        render(world.world, view, {&other.world, view.camera});
    }).find("not a pose of this frame's scene"),
        std::string::npos);
    Camera none = view.camera;
    none.direction = {0, 0, 0};
    EXPECT_THROW(render(world.world, view, {&world.world, none}), ArgumentError);
}

TEST(Motion, LeavesNoPlanesThatNobodyAskedFor)
{
    const TestWorld world = plate({0, 0, 10});
    const View view = straight_view(16, 16, 10);
    const Film film = render(world.world, view, {}, {Aov::motion});
    EXPECT_EQ(film[Aov::motion].value.size(), 2u * 16 * 16);
    EXPECT_TRUE(film.item.empty());
    EXPECT_TRUE(film[Aov::barycentric].empty());
    EXPECT_TRUE(film[Aov::motion_visible].empty());
}

TEST(Tangent, IsThatOfTheVerticesUnitAndWithTheirSide)
{
    TestWorld made = plate({0, 0, 10});
    const View view = straight_view(16, 16, 40);
    const Film without = render(made.world, view, {}, {Aov::tangent});
    for (const float value : without[Aov::tangent].value) EXPECT_EQ(value, 0);

    for (std::size_t k = 0; k < made.world.position.size(); ++k)
        made.world.tangent.emplace_back(
            made.world.position[k].x > 0 ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0), -1);
    const Film film = render(made.world, view, {}, {Aov::tangent, Aov::position, Aov::normal});
    for (std::size_t k = 0; k < 256; ++k) {
        const float* const tangent = &film[Aov::tangent].value[4 * k];
        const double share = (film[Aov::position].value[3 * k] + 3) / 6; // from left to right
        const glm::dvec3 expected = glm::normalize(glm::dvec3(share, 1 - share, 0));
        for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(tangent[axis], expected[axis], 1e-5);
        EXPECT_EQ(tangent[3], -1);
    }
}

TEST(SurfacePlanes, SayWhatTheMaterialIsAtTheHit)
{
    TestWorld made = plate({0, 0, 10});
    made.scene->materials[0].model =
        MetallicRoughness{.metallic = 0.25f, .roughness = 0.5f, .emission = {1, 2, 3}};
    const View view = straight_view(32, 16, 20);
    const Film film =
        render(made.world, view, {}, {Aov::metallic_roughness, Aov::emission, Aov::item});
    int hits = 0;
    for (std::size_t k = 0; k < film.item.size(); ++k) {
        const bool hit = film.item[k] != kNoItem;
        hits += hit;
        EXPECT_EQ(film[Aov::metallic_roughness].value[2 * k], hit ? 0.25f : 0);
        EXPECT_EQ(film[Aov::metallic_roughness].value[2 * k + 1], hit ? 0.5f : 0);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_EQ(film[Aov::emission].value[3 * k + c], hit ? float(c + 1) : 0);
    }
    EXPECT_GT(hits, 50);
}

} // namespace
} // namespace firsthit::test
