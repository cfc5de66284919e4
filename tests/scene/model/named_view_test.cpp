// named_view_test.cpp - cameras that show a world from usual sides and fill the picture.
#include <firsthit/framing.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace firsthit {
namespace {

constexpr NamedView kViews[] = {NamedView::iso, NamedView::front, NamedView::back, NamedView::left,
    NamedView::right, NamedView::top, NamedView::bottom};
const glm::dvec3 kAxes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

/// The least and the largest place of the vertices in the picture, from -1 to 1 on both axes.
struct Extent {
    double left = 1e300, right = -1e300, bottom = 1e300, top = -1e300;
};

Extent extent_of(const World& world, const Camera& camera, double aspect)
{
    const glm::dvec3 ahead = glm::normalize(camera.direction);
    const glm::dvec3 right = glm::normalize(glm::cross(ahead, camera.up));
    const glm::dvec3 up = glm::cross(right, ahead);
    const double tan_y = std::tan(camera.fov_y_rad / 2);
    Extent extent;
    for (const glm::vec3& position : world.position) {
        const glm::dvec3 way = glm::dvec3(position) - camera.eye;
        const double z = glm::dot(way, ahead);
        EXPECT_GT(z, 0);
        const double x = glm::dot(way, right) / (z * tan_y * aspect),
                     y = glm::dot(way, up) / (z * tan_y);
        extent = {std::min(extent.left, x), std::max(extent.right, x), std::min(extent.bottom, y),
            std::max(extent.top, y)};
    }
    return extent;
}

/// Whether the eye is as near to a vertex, along the direction of view, as it may come.
bool is_near(const World& world, const Camera& camera)
{
    const auto [low, high] = bounds(world);
    const glm::dvec3 middle = 0.5 * (glm::dvec3(low) + glm::dvec3(high));
    const glm::dvec3 ahead = glm::normalize(camera.direction);
    double radius = 0, nearest = 1e300;
    for (const glm::vec3& p : world.position) {
        radius = std::max(radius, glm::length(glm::dvec3(p) - middle));
        nearest = std::min(nearest, glm::dot(glm::dvec3(p) - camera.eye, ahead));
    }
    return nearest < 0.1001 * radius;
}

TEST(NamedView, FillsThePictureToItsMarginWhateverTheAspect)
{
    int filled = 0;
    std::mt19937 random(3);
    std::normal_distribution<float> any;
    for (const float size : {1e-20f, 1.0f, 1e20f})
        for (const double aspect : {0.2, 1.0, 16.0 / 9})
            for (const glm::dvec3& axis : kAxes)
                for (const NamedView view : kViews) {
                    World world;
                    for (int k = 0; k < 60; ++k)
                        world.position.push_back(
                            size * glm::vec3(any(random) + 2, 3 * any(random), any(random)));
                    Framing framing = named_view(view, axis);
                    framing.aspect = aspect;
                    const Camera camera = framing_camera(world, framing);
                    const Extent e = extent_of(world, camera, aspect);
                    const double farthest = std::max({-e.left, e.right, -e.bottom, e.top});
                    EXPECT_LT(farthest, 0.95 + 1e-6);
                    EXPECT_NEAR(e.right, -e.left, 1e-6); // in the middle, also between free sides
                    EXPECT_NEAR(e.top, -e.bottom, 1e-6);
                    if (is_near(world, camera)) continue; // a tip points at the eye
                    ++filled;
                    EXPECT_NEAR(farthest, 0.95, 1e-6);
                    const bool fills_width =
                        std::abs(e.right - 0.95) < 1e-6 && std::abs(e.left + 0.95) < 1e-6;
                    const bool fills_height =
                        std::abs(e.top - 0.95) < 1e-6 && std::abs(e.bottom + 0.95) < 1e-6;
                    EXPECT_TRUE(fills_width || fills_height);
                }
    EXPECT_GT(filled, 300);
}

TEST(NamedView, KeepsAllInThePictureAllAround)
{
    std::mt19937 random(4);
    std::normal_distribution<float> any;
    World world;
    for (int k = 0; k < 60; ++k)
        world.position.emplace_back(5 * any(random), any(random), any(random));
    Framing framing = named_view(NamedView::iso, {0, 1, 0});
    framing.aspect = 1.5;
    framing.all_around = true;
    const Camera camera = framing_camera(world, framing);
    const auto [low, high] = bounds(world);
    const glm::dvec3 middle = 0.5 * (glm::dvec3(low) + glm::dvec3(high));
    for (int k = 0; k < 24; ++k) {
        const Extent e =
            extent_of(world, turned_camera(camera, middle, {0, 2, 0}, k * 0.2617993877991494), 1.5);
        EXPECT_LT(std::max({-e.left, e.right, -e.bottom, e.top}), 0.951);
    }
}

TEST(NamedView, SeesWorldsWithoutExtent)
{
    for (const NamedView view : kViews)
        for (const glm::vec3 far : {glm::vec3(0), glm::vec3(1e6f, 3, -2), glm::vec3(0, 0, 1e30f)}) {
            World world;
            world.position = {far};
            extent_of(world, framing_camera(world, named_view(view, {0, 0, 1})), 1);
            world.position = {far, far + glm::vec3(0, 0, 1 + std::abs(far.x) + std::abs(far.z))};
            extent_of(world, framing_camera(world, named_view(view, {0, 0, 1})), 1);
        }
    const Camera camera = framing_camera(World(), named_view(NamedView::iso, {0, 1, 0}));
    EXPECT_TRUE(std::isfinite(glm::length(camera.eye)));
}

TEST(NamedView, HasXToTheRightInTheFront)
{
    for (const glm::dvec3 axis : {glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
        const Framing front = named_view(NamedView::front, axis);
        EXPECT_EQ(glm::cross(-front.towards_eye, front.up), glm::dvec3(1, 0, 0));
        EXPECT_EQ(front.up, axis);
        EXPECT_EQ(named_view(NamedView::right, axis).towards_eye, glm::dvec3(1, 0, 0));
        EXPECT_EQ(named_view(NamedView::left, axis).towards_eye, glm::dvec3(-1, 0, 0));
        // Plan: the front at the bottom of the picture, x to the right.
        const Framing top = named_view(NamedView::top, axis);
        EXPECT_EQ(top.up, -front.towards_eye);
        EXPECT_EQ(glm::cross(-top.towards_eye, top.up), glm::dvec3(1, 0, 0));
    }
}

TEST(NamedView, TurnsCounterClockwiseSeenFromAbove)
{
    const Camera turned =
        turned_camera({.eye = {1, 2, 13}, .direction = {0, 0, -1}, .up = {0, 1, 0}}, {1, 2, 3},
            {0, 5, 0}, 1.5707963267948966);
    EXPECT_LT(glm::length(turned.eye - glm::dvec3(11, 2, 3)), 1e-12);
    EXPECT_LT(glm::length(turned.direction - glm::dvec3(-1, 0, 0)), 1e-12);
    EXPECT_LT(glm::length(turned.up - glm::dvec3(0, 1, 0)), 1e-12);
}

} // namespace
} // namespace firsthit
