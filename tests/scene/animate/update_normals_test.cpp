// update_normals_test.cpp - normals of positions that were moved by hand.
#include "scene/model/borrow.h"
#include "message_of.h"
#include "scene/model/smooth_normals.h"

#include <firsthit/error.h>
#include <firsthit/normals.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace firsthit {
namespace {

/// A square of n x n cells over [0, 1]^2 whose triangles share vertices.
Scene grid(std::uint32_t n)
{
    std::vector<glm::vec3> position;
    std::vector<glm::uvec3> index;
    for (std::uint32_t y = 0; y <= n; ++y)
        for (std::uint32_t x = 0; x <= n; ++x)
            position.emplace_back(float(x) / float(n), float(y) / float(n), 0);
    for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t v = y * (n + 1) + x;
            index.emplace_back(v, v + 1, v + n + 2);
            index.emplace_back(v, v + n + 2, v + n + 1);
        }
    std::vector<glm::vec3> normal(position.size(), glm::vec3(0, 0, 1));
    return scene_from_arrays(position, index, normal);
}

void shake(World& world, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> by(-0.02f, 0.02f);
    for (glm::vec3& p : world.position) p += glm::vec3(by(random), by(random), 4 * by(random));
}

/// Max's formula as the paper has it, vertex by vertex over all triangles, from angles.
glm::dvec3 oracle(const World& world, std::uint32_t vertex)
{
    glm::dvec3 sum(0);
    for (const glm::uvec3& corners : world.scene->index)
        for (int k = 0; k < 3; ++k) {
            if (corners[k] != vertex) continue;
            const glm::dvec3 p(world.position[vertex]);
            const glm::dvec3 a = glm::dvec3(world.position[corners[(k + 1) % 3]]) - p;
            const glm::dvec3 b = glm::dvec3(world.position[corners[(k + 2) % 3]]) - p;
            const double angle = std::acos(glm::dot(a, b) / (glm::length(a) * glm::length(b)));
            sum += glm::normalize(glm::cross(a, b)) *
                   (std::sin(angle) / (glm::length(a) * glm::length(b)));
        }
    return glm::normalize(sum);
}

TEST(UpdateNormals, AreThoseOfThePapersFormula)
{
    const Scene scene = grid(12);
    World world;
    pose(borrow(scene), 0, world);
    for (const unsigned seed : {1u, 2u, 3u}) {
        shake(world, seed);
        update_normals(world);
        for (std::uint32_t v = 0; v < world.position.size(); ++v)
            EXPECT_LT(glm::length(glm::dvec3(world.normal[v]) - oracle(world, v)), 2e-7)
                << "vertex " << v << ", seed " << seed;
    }
}

TEST(UpdateNormals, AreRightOnASphere)
{
    // Max's weights are exact there, however uneven the triangles are.
    Scene scene = grid(16);
    World world;
    pose(borrow(scene), 0, world);
    for (glm::vec3& p : world.position) {
        const double around = p.x * p.x * 2.0;
        const double up = p.y * 1.2;
        p = glm::vec3(glm::dvec3(
            std::cos(around) * std::cos(up), std::sin(around) * std::cos(up), std::sin(up)));
    }
    update_normals(world);
    for (std::uint32_t v = 0; v < world.position.size(); ++v) {
        const std::uint32_t x = v % 17;
        const std::uint32_t y = v / 17;
        if (x == 0 || y == 0 || x == 16 || y == 16) continue; // the border is not surrounded
        EXPECT_LT(glm::length(world.normal[v] - world.position[v]), 1e-4f) << "vertex " << v;
    }
}

TEST(UpdateNormals, AreThoseThatLoadingMakesToTheBit)
{
    const Scene scene = grid(12);
    World shaken;
    pose(borrow(scene), 0, shaken);
    shake(shaken, 5);
    update_normals(shaken);
    EXPECT_EQ(shaken.normal, smooth_normals(shaken.position, scene.index, std::numbers::pi).normal);

    // Flat, because no vertex is shared.
    const std::vector<glm::vec3> corner{{0, 0, 0}, {1, 0, 0.3f}, {0, 1, 0.2f}, {0.1f, 0.2f, 1}};
    const Scene flat = scene_from_arrays(corner, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
    World world;
    pose(borrow(flat), 0, world);
    update_normals(world);
    EXPECT_EQ(world.normal, flat.normal);
}

TEST(UpdateNormals, DoNotDependOnThreads)
{
    const Scene scene = grid(40);
    World world;
    pose(borrow(scene), 0, world);
    shake(world, 7);
    update_normals(world, 1);
    const std::vector<glm::vec3> one = world.normal;
    for (const int threads : {2, 3, 7, 0}) {
        std::fill(world.normal.begin(), world.normal.end(), glm::vec3(9));
        update_normals(world, threads);
        EXPECT_EQ(world.normal, one) << threads << " threads";
    }
}

TEST(UpdateNormals, LeaveOutTrianglesWithoutAreaAndCornersThatAreNotFinite)
{
    const Scene scene = scene_from_arrays({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}, {-1, 0, 0}},
        {{0, 1, 2}, {0, 1, 1}, {0, 2, 4}, {3, 3, 3}}, std::vector<glm::vec3>(5, {1, 0, 0}));
    World world;
    pose(borrow(scene), 0, world);
    world.position[4].y = std::numeric_limits<float>::quiet_NaN();
    update_normals(world);
    for (const glm::vec3& n : world.normal) EXPECT_EQ(n, glm::vec3(0, 0, 1));
}

TEST(UpdateNormals, RefuseWorldsThatTheyDoNotFit)
{
    World world;
    EXPECT_EQ(message_of<ArgumentError>([&] { update_normals(world); }),
        "normals are of a world that was posed before");
    Scene scene = grid(1);
    pose(borrow(scene), 0, world);
    world.position.pop_back();
    EXPECT_EQ(message_of<ArgumentError>([&] { update_normals(world); }),
        "a world with 3 positions, its scene has 4 vertices");
    pose(borrow(scene), 0, world);
    scene.index[1].y = 4;
    EXPECT_EQ(message_of<SceneError>([&] { update_normals(world, 2); }),
        "arrays: triangle 1: vertex 4 is out of range (4 exist)");
}

} // namespace
} // namespace firsthit
