// upward_axis_test.cpp - models that rest on a flat bottom show which way is up.
#include "scene/animate/pose.h"

#include <firsthit/framing.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace firsthit {
namespace {

const glm::dvec3 kY(0, 1, 0), kZ(0, 0, 1);

World world_of(const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles)
{
    World world;
    pose(scene_from_arrays(positions, triangles), 0, world);
    return world;
}

/// A cone whose flat bottom is turned away from the axis.
World cone(int axis)
{
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::vector<glm::vec3> positions(2, glm::vec3(0));
    std::vector<glm::uvec3> triangles;
    positions[1][axis] = 3;
    for (unsigned k = 0; k < 12; ++k) {
        glm::vec3 rim(0);
        rim[u] = std::cos(0.5235988f * float(k)), rim[v] = std::sin(0.5235988f * float(k));
        positions.push_back(rim);
        const unsigned next = 2 + (k + 1) % 12;
        triangles.emplace_back(0, next, 2 + k);
        triangles.emplace_back(1, 2 + k, next);
    }
    return world_of(positions, triangles);
}

TEST(UpwardAxis, IsTheOneThatAModelRestsAlong)
{
    EXPECT_EQ(upward_axis(cone(1), kZ), kY);
    EXPECT_EQ(upward_axis(cone(2), kZ), kZ);
    EXPECT_EQ(upward_axis(cone(1), kY), kY);
    EXPECT_EQ(upward_axis(cone(2), kY), kZ);
}

TEST(UpwardAxis, IsTheUsualOneWhereNeitherOrBothAreFlat)
{
    EXPECT_EQ(upward_axis(cone(0), kZ), kZ); // rests along x
    EXPECT_EQ(upward_axis(cone(0), kY), kY);
    const World sheet = world_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    EXPECT_EQ(upward_axis(sheet, kZ), kZ);
    EXPECT_EQ(upward_axis(sheet, kY), kY);
    const std::vector<glm::vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const World corner = world_of(corners, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
    EXPECT_EQ(upward_axis(corner, kZ), kZ);
    EXPECT_EQ(upward_axis(corner, kY), kY);
}

TEST(UpwardAxis, LeavesOtherAxesAndEmptyWorldsAsTheyAre)
{
    EXPECT_EQ(upward_axis(cone(1), glm::dvec3(1, 0, 0)), glm::dvec3(1, 0, 0));
    EXPECT_EQ(upward_axis(cone(1), glm::dvec3(0, -1, 0)), glm::dvec3(0, -1, 0));
    EXPECT_EQ(upward_axis(world_of({}, {}), kZ), kZ);
}

} // namespace
} // namespace firsthit
