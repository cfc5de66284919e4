// watertight_test.cpp - every ray meets a surface once, also through its edges and vertices.
#include "exact/hit.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace firsthit {
namespace {

using glm::vec3;
using Triangles = std::vector<Corners>;

int hits(const Triangles& triangles, const vec3& d, Effort& effort)
{
    int count = 0;
    for (const Corners& c : triangles) count += is_hit(c, d, effort);
    return count;
}

/// A flat or wavy grid of 2 n n triangles whose vertices project to the points (i, j) - n/2 + 1/2.
template <class F>
Triangles grid(int n, std::mt19937& random, const F& point)
{
    Triangles triangles;
    std::vector<vec3> p;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            p.push_back(point(float(i - n / 2) + .5f, float(j - n / 2) + .5f));
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const auto at = [&](int x, int y) { return p[std::size_t((j + y) * (n + 1) + i + x)]; };
            if (random() & 1) {
                triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
                triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
            } else {
                triangles.push_back({at(0, 0), at(1, 0), at(0, 1)});
                triangles.push_back({at(1, 0), at(1, 1), at(0, 1)});
            }
        }
    }
    return triangles;
}

void expect_once(const Triangles& triangles, int half)
{
    Effort effort;
    for (int j = -half; j <= half; ++j)
        for (int i = -half; i <= half; ++i)
            EXPECT_EQ(hits(triangles, {float(i) + .5f, float(j) + .5f, 1}, effort), 1)
                << "ray " << i << ", " << j;
}

TEST(Watertight, RaysThroughVerticesHitOneTriangle)
{
    for (unsigned seed = 0; seed < 5; ++seed) {
        std::mt19937 random(seed);
        expect_once(grid(16, random, [](float x, float y) { return vec3(4 * x, 4 * y, 4); }), 6);
    }
}

TEST(Watertight, RaysWithinRoundingOfVerticesHitOneTriangle)
{
    for (unsigned seed = 0; seed < 5; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> depth(2, 5);
        expect_once(grid(16, random,
                        [&](float x, float y) {
                            const float z = depth(random);
                            return vec3(x * z, y * z, z);
                        }),
            6);
    }
}

/// A closed sphere of latitude and longitude quads, poles and seam shared.
Triangles sphere(const vec3& center, float radius, int n)
{
    const auto point = [&](int i, int j) {
        if (j == 0) return center + vec3(0, radius, 0);
        if (j == n) return center - vec3(0, radius, 0);
        const float a = 6.2831853f * float(i % (2 * n)) / float(2 * n),
                    b = 3.1415927f * float(j) / float(n);
        return center +
               radius * vec3(std::sin(b) * std::cos(a), std::cos(b), std::sin(b) * std::sin(a));
    };
    Triangles triangles;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < 2 * n; ++i) {
            if (j > 0) triangles.push_back({point(i, j), point(i + 1, j), point(i + 1, j + 1)});
            if (j < n - 1) triangles.push_back({point(i, j), point(i + 1, j + 1), point(i, j + 1)});
        }
    }
    return triangles;
}

TEST(Watertight, EveryRayFromInsideAClosedMeshHitsItOddlyOften)
{
    const Triangles mesh = sphere({0, 0, 0}, 2, 10);
    Effort effort;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> any(-1, 1);
    for (int k = 0; k < 4000; ++k) {
        const vec3 d(any(random), any(random), any(random));
        EXPECT_EQ(hits(mesh, d, effort), 1);
    }
    // Straight through each vertex and each edge's middle.
    for (const Corners& c : mesh) {
        EXPECT_EQ(hits(mesh, c[0], effort), 1);
        EXPECT_EQ(hits(mesh, c[0] + c[1], effort), 1);
        EXPECT_EQ(hits(mesh, c[1] + c[2], effort), 1);
    }
}

TEST(Watertight, NoneOfHalfAMillionRaysInsideAClosedMeshEscapes)
{
    const Triangles mesh = sphere({0, 0, 0}, 3, 6);
    Effort effort;
    int escaped = 0;
    for (int j = 0; j < 512; ++j) {
        for (int i = 0; i < 1024; ++i) {
            const float a = 6.2831853f * float(i) / 1024, b = 3.1415927f * float(j) / 512;
            escaped +=
                hits(mesh, {std::sin(b) * std::cos(a), std::cos(b), std::sin(b) * std::sin(a)},
                    effort) != 1;
        }
    }
    EXPECT_EQ(escaped, 0);
}

TEST(Watertight, RaysThroughTheCornersOfASubdividedBoxHitItOnce)
{
    // Each face 8 x 8 quads; rays from inside through every corner and every edge's middle.
    Triangles box;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            const auto point = [&](int i, int j) {
                vec3 p;
                p[axis] = side;
                p[(axis + 1) % 3] = float(i) / 4 - 1;
                p[(axis + 2) % 3] = float(j) / 4 - 1;
                return p - vec3(0.25f, -0.125f, 0.0625f);
            };
            for (int j = 0; j < 8; ++j) {
                for (int i = 0; i < 8; ++i) {
                    box.push_back({point(i, j), point(i + 1, j), point(i + 1, j + 1)});
                    box.push_back({point(i, j), point(i + 1, j + 1), point(i, j + 1)});
                }
            }
        }
    }
    Effort effort;
    for (const Corners& c : box) {
        EXPECT_EQ(hits(box, c[0], effort), 1);
        EXPECT_EQ(hits(box, c[1] + c[2], effort), 1);
    }
}

TEST(Watertight, EveryRayFromOutsideAClosedMeshHitsItEvenlyOften)
{
    const Triangles mesh = sphere({0.5f, -0.25f, 4}, 2, 10);
    Effort effort;
    int through = 0;
    const auto expect_even = [&](const vec3& d) {
        const int count = hits(mesh, d, effort);
        EXPECT_EQ(count % 2, 0);
        through += count > 0;
    };
    for (const Corners& c : mesh) { // silhouettes and folds are among them
        expect_even(c[0]);
        expect_even(c[0] + c[1]);
        expect_even(c[0] + c[1] + c[2]);
    }
    EXPECT_GT(through, 100);
}

TEST(Watertight, TwoSpheresAHairApartKeepTheirOrder)
{
    const Triangles inner = sphere({0, 0, 0}, 1, 24), outer = sphere({0, 0, 0}, 1 + 4e-5f, 24);
    Effort effort;
    std::mt19937 random(8);
    std::uniform_real_distribution<float> any(-1, 1);
    for (int k = 0; k < 3000; ++k) {
        const vec3 d(any(random), any(random), any(random));
        const Corners *first_inner = nullptr, *first_outer = nullptr;
        for (const Corners& c : inner)
            if (is_hit(c, d, effort)) first_inner = &c;
        for (const Corners& c : outer)
            if (is_hit(c, d, effort)) first_outer = &c;
        ASSERT_TRUE(first_inner && first_outer);
        EXPECT_EQ(compare_depth(*first_inner, *first_outer, d, effort), -1);
    }
}

} // namespace
} // namespace firsthit
