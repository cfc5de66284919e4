// hang_lights_test.cpp - lights that go with the camera.
#include <firsthit/scene.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace firsthit {
namespace {

/// One triangle with a light on the camera and one that stands.
World lit_world()
{
    Scene scene = scene_from_arrays({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    Light hung{.position = {1, 2, 3}, .direction = {0, 0, -1}, .on_camera = true};
    const Light stands{.position = {1, 2, 3}, .direction = {0, 0, -1}};
    scene.lights = {hung, stands};
    World world;
    pose(std::move(scene), 0, world);
    return world;
}

void expect_same_place(const glm::dvec3& a, const glm::dvec3& b)
{
    EXPECT_LT(glm::length(a - b), 1e-12) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(HangLights, TurnsPositionsAndDirectionsWithTheCamera)
{
    World world = lit_world();
    // Looks along x; its right is z, what is behind it is -x.
    hang_lights({.eye = {10, 20, 30}, .direction = {2, 0, 0}, .up = {1, 5, 0}}, world);
    expect_same_place(world.lights[0].position, {10 - 3, 20 + 2, 30 + 1});
    expect_same_place(world.lights[0].direction, {1, 0, 0});
    EXPECT_EQ(world.lights[1].position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(world.lights[1].direction, glm::dvec3(0, 0, -1));
}

TEST(HangLights, DoesNotAddUp)
{
    World world = lit_world();
    const Camera camera{.eye = {1, 1, 1}, .direction = {0, -1, 0}, .up = {0, 0, -1}};
    hang_lights(camera, world);
    const Light once = world.lights[0];
    hang_lights(camera, world);
    EXPECT_EQ(world.lights[0].position, once.position);
    EXPECT_EQ(world.lights[0].direction, once.direction);
}

TEST(HangLights, LeavesLightsWhereACameraHasNoDirection)
{
    World world = lit_world();
    const Light before = world.lights[0];
    for (const glm::dvec3 up : {glm::dvec3(0), glm::dvec3(0, 0, 4), glm::dvec3(std::nan(""))}) {
        hang_lights({.eye = {9, 9, 9}, .direction = {0, 0, -1}, .up = up}, world);
        EXPECT_EQ(world.lights[0].position, before.position);
        EXPECT_EQ(world.lights[0].direction, before.direction);
    }
    World empty;
    hang_lights({}, empty);
}

TEST(HangLights, FollowsTheScenesOwnCameraWhenPosed)
{
    World world = lit_world();
    // Seen by framing_camera, which looks down a little.
    EXPECT_LT(world.lights[0].direction.z, -0.9);
    EXPECT_LT(world.lights[0].direction.y, -0.1);
    EXPECT_LT(
        glm::length(world.lights[0].direction - glm::normalize(world.camera.direction)), 1e-12);
}

} // namespace
} // namespace firsthit
