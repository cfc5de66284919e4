// framing_test.cpp - bounds, and the camera that sees all.
#include <firsthit/scene.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace firsthit {
namespace {

World world_of(std::vector<glm::vec3> position)
{
    World world;
    world.position = std::move(position);
    return world;
}

/// Every vertex lies inside the camera's cone, in front of it.
void expect_all_seen(const World& world)
{
    const Camera camera = framing_camera(world);
    const glm::dvec3 ahead = glm::normalize(camera.direction);
    for (const glm::vec3& p : world.position) {
        const glm::dvec3 way = glm::dvec3(p) - camera.eye;
        EXPECT_GT(glm::length(way), 0);
        EXPECT_GT(glm::dot(way, ahead), glm::length(way) * std::cos(camera.fov_y_rad / 2));
    }
}

TEST(Framing, FindsTheSmallestAndLargestCoordinates)
{
    const auto [low, high] = bounds(world_of({{1, -2, 3}, {-1, 5, 3}, {0, 0, 9}}));
    EXPECT_EQ(low, glm::vec3(-1, -2, 3));
    EXPECT_EQ(high, glm::vec3(1, 5, 9));
}

TEST(Framing, GivesAnEmptyWorldZeroBounds)
{
    EXPECT_EQ(bounds(World())[0], glm::vec3(0));
    EXPECT_EQ(bounds(World())[1], glm::vec3(0));
}

TEST(Framing, SeesEveryVertexOfAnyCloud)
{
    std::mt19937 random(7);
    std::normal_distribution<float> any;
    for (const float size : {1e-30f, 1e-3f, 1.0f, 1e30f}) {
        std::vector<glm::vec3> points;
        for (int k = 0; k < 100; ++k)
            points.push_back(size * glm::vec3(any(random), 3 * any(random), any(random)));
        expect_all_seen(world_of(points));
    }
}

TEST(Framing, SeesFlatAndLongAndFarWorlds)
{
    expect_all_seen(world_of({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}));
    expect_all_seen(world_of({{-1e6f, 0, 0}, {1e6f, 0, 0}}));
    expect_all_seen(world_of({{0, 0, -5}, {0, 0, 5}}));
    expect_all_seen(world_of({{1e8f, 1e8f, 1e8f}, {1e8f + 8, 1e8f, 1e8f}}));
}

TEST(Framing, SeesASinglePointWhereverItIs)
{
    for (const float at : {0.0f, 1.0f, -1e20f, 3e38f}) expect_all_seen(world_of({glm::vec3(at)}));
}

TEST(Framing, SeesTheLargestWorldThereIs)
{
    expect_all_seen(world_of({glm::vec3(-3.4e38f), glm::vec3(3.4e38f)}));
}

TEST(Framing, LooksFromTheFrontAndSlightlyAbove)
{
    const Camera camera = framing_camera(world_of({{-1, -1, -1}, {1, 1, 1}}));
    EXPECT_GT(camera.eye.z, 2);
    EXPECT_EQ(camera.eye.x, 0);
    EXPECT_GT(camera.eye.y, 0);
    EXPECT_LT(camera.eye.y, 0.5 * camera.eye.z);
    EXPECT_DOUBLE_EQ(camera.fov_y_rad, std::acos(-1.0) / 4);
}

TEST(Framing, GivesAnEmptyWorldSomeCamera)
{
    const Camera camera = framing_camera(World());
    EXPECT_TRUE(std::isfinite(camera.eye.z));
    EXPECT_NE(camera.direction, glm::dvec3(0));
}

} // namespace
} // namespace firsthit
