// intersect_test.cpp - the float text that shaders intersect by, against the exact predicate.
#include "base/scalar_real.h"
#include "exact/hit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace firsthit {
namespace scalar {
namespace {
#include "glsl/intersect.glsl"
} // namespace
} // namespace scalar

namespace {

scalar::real3 real3_of(const glm::vec3& v)
{
    return {v.x, v.y, v.z};
}

scalar::TriangleHit intersect(const Corners& c, const glm::vec3& d)
{
    return scalar::intersect(real3_of(c[0]), real3_of(c[1]), real3_of(c[2]), real3_of(d));
}

/// A corner that is seen at (x, y), at depth z.
glm::vec3 seen_at(float x, float y, float z)
{
    return {x * z, y * z, z};
}

/// The area that a triangle covers.
float samples_of(const Corners& c)
{
    const auto x = [&](int k) { return c[std::size_t(k)].x / c[std::size_t(k)].z; };
    const auto y = [&](int k) { return c[std::size_t(k)].y / c[std::size_t(k)].z; };
    return std::abs((x(1) - x(0)) * (y(2) - y(0)) - (y(1) - y(0)) * (x(2) - x(0))) / 2;
}

class Intersect : public testing::Test {
  protected:
    float random(float low, float high)
    {
        return std::uniform_real_distribution<float>(low, high)(engine);
    }
    /// About `size` samples wide, within 512 samples of the axis.
    Corners random_triangle(float size, float depth_spread = 0.1f)
    {
        const float x = random(-512, 512), y = random(-512, 512), z = random(1, 100);
        Corners c;
        for (glm::vec3& corner : c)
            corner = seen_at(x + random(-size, size), y + random(-size, size),
                z * random(1 - depth_spread, 1 + depth_spread));
        return c;
    }
    std::mt19937 engine{7};
};

TEST_F(Intersect, AgreesWithTheExactPredicateBeyondAThousandthOfASample)
{
    Effort effort;
    int hits = 0;
    for (int k = 0; k < 100000; ++k) {
        const Corners c = random_triangle(random(0.5f, 50), 0.01f);
        const float x = std::round(c[0].x / c[0].z), y = std::round(c[0].y / c[0].z);
        const glm::vec3 d(x, y, 1);
        // Nearby rays that all hit or all miss leave no doubt.
        int near = 0;
        for (const float e : {-1e-3f, 1e-3f})
            near += is_hit(c, {x + e, y + e, 1}, effort) + is_hit(c, {x + e, y - e, 1}, effort);
        if (near != 0 && near != 4) continue;
        const bool hit = is_hit(c, d, effort);
        if (hit != (near == 4)) continue;
        hits += hit;
        ASSERT_EQ(intersect(c, d).hit, hit) << k;
    }
    EXPECT_GT(hits, 1000);
}

TEST_F(Intersect, FindsWhereTrianglesOfSomeSamplesAreHit)
{
    Effort effort;
    for (int k = 0; k < 100000; ++k) {
        const Corners c = random_triangle(random(5, 50));
        const glm::vec3 d(std::round(c[0].x / c[0].z), std::round(c[0].y / c[0].z), 1);
        const scalar::TriangleHit hit = intersect(c, d);
        if (samples_of(c) < 10 || !hit.hit || !is_hit(c, d, effort)) continue;
        // Corners differ in depth by a tenth or more: a thousandth of a weight.
        ASSERT_NEAR(hit.t, hit_depth(c, d), 1e-4 * hit_depth(c, d));
        const auto [u, v] = exact_barycentrics(c, d);
        ASSERT_NEAR(hit.u, u, 1e-3);
        ASSERT_NEAR(hit.v, v, 1e-3);
    }
}

TEST_F(Intersect, LosesNoRayBetweenTwoTrianglesOnASharedEdge)
{
    for (int k = 0; k < 100000; ++k) {
        // The edge from a to b passes the ray within rounding; p and q are on either side of it.
        const float x = std::round(random(-512, 512)), y = std::round(random(-512, 512));
        const float dx = random(0.5f, 3), dy = random(-3, 3);
        const glm::vec3 a = seen_at(x - dx, y - dy, random(1, 100)),
                        b = seen_at(x + dx, y + dy, random(1, 100));
        const glm::vec3 p = seen_at(x - dy, y + dx, random(1, 100)),
                        q = seen_at(x + dy, y - dx, random(1, 100));
        const glm::vec3 d(x, y, 1);
        ASSERT_TRUE(intersect({a, b, p}, d).hit || intersect({b, a, q}, d).hit) << k;
    }
}

TEST_F(Intersect, HitsNothingBehindTheEye)
{
    const Corners behind = {glm::vec3(-1, -1, -2), glm::vec3(1, -1, -2), glm::vec3(0, 1, -2)};
    EXPECT_FALSE(intersect(behind, {0, 0, 1}).hit);
}

TEST_F(Intersect, HitsNoTriangleWithoutArea)
{
    const glm::vec3 a(1, 2, 3), b(2, 4, 6);
    EXPECT_FALSE(intersect({a, a, a}, {0, 0, 1}).hit);
    EXPECT_FALSE(intersect({a, b, a}, {0, 0, 1}).hit);
}

} // namespace
} // namespace firsthit
