// raster_depth_test.cpp - depths of a shadow map's tile agree with the triangles that rays hit.
#include "shadow/map/raster_depth.h"

#include "cpu/adversarial_scenes.h"
#include "instruction_sets.h"
#include "items.h"
#include "visibility/bin/bin_triangles.h"
#include "visibility/bin/view_memory.h"

#include <algorithm>
#include <vector>

namespace firsthit::test {
namespace {

constexpr int kTileSide = 16;

/// 1/t of all samples, row by row.
std::vector<float> depths_of(const World& world, TinyTriangles tiny)
{
    Tasks tasks(1);
    const View view = checked(straight_view(kSize, kSize, kSize));
    ViewMemory memory;
    lay_out(pencil_of(view, view.region, 1), kTileSide, memory);
    take_triangles(*world.scene, memory);
    project_vertices(world.position, memory.pencil, memory, tasks, CornerSpace::flat);
    bin_triangles(memory, memory, memory, tasks, tiny);
    DepthTile tile;
    resize(tile, kTileSide);
    std::vector<float> w(std::size_t(kSize) * kSize);
    for (int number = 0; number < memory.tiles(); ++number) {
        raster_depth(memory, memory.rays(number), depth_bin_of(memory, std::size_t(number)), tile);
        for (int y = 0; y < kTileSide; ++y)
            for (int x = 0; x < kTileSide; ++x)
                w[std::size_t((memory.first_y(number) + y) * kSize + memory.first_x(number) + x)] =
                    tile.w[std::size_t(tile_offset(x, y, kTileSide))];
    }
    return w;
}

template <class F>
void for_tiny_worlds(const F& check)
{
    std::vector<AdversarialScene> scenes;
    add_tiny_scenes(scenes);
    for (const AdversarialScene& scene : scenes) {
        SCOPED_TRACE(scene.name);
        std::mt19937 random(3);
        TestWorld world;
        scene.fill(world, random);
        world.finish();
        check(world.world);
    }
}

TEST(RasterDepth, CoversEverySampleThatATinyTriangleHits)
{
    for_tiny_worlds([](const World& world) {
        const std::vector<float> w = depths_of(world, TinyTriangles::depths);
        const EyeWorld eye(world, straight_view(kSize, kSize, kSize));
        Effort effort;
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                double least = 0; // 1/t of the farthest corner of each triangle that is hit
                for (std::size_t t = 0; t < world.scene->index.size(); ++t) {
                    const Corners& c = eye.triangles[std::uint32_t(t)];
                    const double farthest = std::max({c[0].z, c[1].z, c[2].z});
                    if (1 / farthest > least && is_hit(c, eye.ray(x, y), effort))
                        least = 1 / farthest;
                }
                EXPECT_GE(double(w[std::size_t(y * kSize + x)]), least * (1 - 0x1p-20));
            }
        }
    });
}

TEST(RasterDepth, IsNoNearerThanTheNearestTriangleInReach)
{
    for_tiny_worlds([](const World& world) {
        const std::vector<float> w = depths_of(world, TinyTriangles::depths);
        const EyeWorld eye(world, straight_view(kSize, kSize, kSize));
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const glm::dvec3 d(eye.ray(x, y));
                double most = 0;
                for (std::size_t t = 0; t < world.scene->index.size(); ++t) {
                    const Corners& c = eye.triangles[std::uint32_t(t)];
                    const auto outside = [&](int axis, double side) {
                        return std::all_of(c.begin(), c.end(), [&](const glm::vec3& p) {
                            return side * (double(p[axis]) / double(p.z) - d[axis]) > 1e-3;
                        });
                    };
                    if (outside(0, 1) || outside(0, -1) || outside(1, 1) || outside(1, -1))
                        continue;
                    most = std::max(most, 1 / double(std::min({c[0].z, c[1].z, c[2].z})));
                }
                EXPECT_LE(double(w[std::size_t(y * kSize + x)]), most * (1 + 0x1p-20));
            }
        }
    });
}

TEST(RasterDepth, OfTinyTrianglesEqualsThatOfTheGeneralKernelAwayFromEdges)
{
    for_tiny_worlds([](const World& world) {
        const std::vector<float> fast = depths_of(world, TinyTriangles::depths);
        const std::vector<float> plain = depths_of(world, TinyTriangles::entries);
        std::size_t differ = 0;
        for (std::size_t k = 0; k < fast.size(); ++k)
            differ += std::abs(fast[k] - plain[k]) > 1e-3f * plain[k];
        EXPECT_LE(differ, fast.size() / 20);
    });
}

/// Large triangles around the eye, most of which reach behind it.
TestWorld around_the_eye()
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> side(-4, 4), along(-3, 6);
    TestWorld world;
    const auto corner = [&] { return glm::vec3(side(random), side(random), along(random)); };
    for (int k = 0; k < 60; ++k) {
        const glm::vec3 a = corner(), b = corner(), c = corner();
        world.add(a, b, c);
    }
    world.finish();
    return world;
}

TEST(RasterDepth, OfTrianglesThatReachBehindTheLightEqualsThatOfTheirHits)
{
    const TestWorld world = around_the_eye();
    const std::vector<float> w = depths_of(world.world, TinyTriangles::depths);
    const EyeWorld eye(world.world, straight_view(kSize, kSize, kSize));
    Effort effort;
    std::size_t differ = 0, hits = 0;
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const glm::dvec3 d(eye.ray(x, y));
            double nearest = 0; // 1/t
            for (std::size_t t = 0; t < world.world.scene->index.size(); ++t) {
                const Corners& c = eye.triangles[std::uint32_t(t)];
                if (!is_hit(c, eye.ray(x, y), effort)) continue;
                const glm::dvec3 a(c[0]);
                const glm::dvec3 n = glm::cross(glm::dvec3(c[1]) - a, glm::dvec3(c[2]) - a);
                nearest = std::max(nearest, glm::dot(n, d) / glm::dot(n, a));
            }
            hits += nearest > 0;
            differ +=
                std::abs(double(w[std::size_t(y * kSize + x)]) - nearest) > 1e-4 * nearest + 1e-9;
        }
    }
    EXPECT_GT(hits, std::size_t(kSize * kSize / 2));
    EXPECT_LE(differ, std::size_t(kSize * kSize / 500)); // on edges
    for_instruction_sets([&] { EXPECT_EQ(depths_of(world.world, TinyTriangles::depths), w); });
}

TEST(RasterDepth, IsTheSameOnEveryInstructionSet)
{
    for_tiny_worlds([](const World& world) {
        const std::vector<float> expected = depths_of(world, TinyTriangles::depths);
        for_instruction_sets([&] { EXPECT_EQ(depths_of(world, TinyTriangles::depths), expected); });
    });
}

} // namespace
} // namespace firsthit::test
