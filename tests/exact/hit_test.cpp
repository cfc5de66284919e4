// hit_test.cpp - the predicates against integers of 128 bits, and at the ends of their range.
#include "exact/hit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace firsthit {
namespace {

__extension__ typedef __int128 Integer;
using glm::vec3;

int sign(Integer v)
{
    return v > 0 ? 1 : v < 0 ? -1 : 0;
}

struct Exact {
    Integer x, y, z;
};

Exact exact(const vec3& p)
{
    return {Integer(p.x), Integer(p.y), Integer(p.z)};
}

Exact cross(const Exact& a, const Exact& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Integer dot(const Exact& a, const Exact& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Sign of d . (a x b), then of what an infinitesimal displacement of d adds.
int displaced_sign(const vec3& a, const vec3& b, const vec3& d)
{
    const Exact n = cross(exact(a), exact(b));
    for (const Integer term : {dot(exact(d), n), n.x, n.y, n.z})
        if (term != 0) return sign(term);
    return 0;
}

/// Points with coordinates of up to `bits` bits; now and then small, equal or in line, so that
/// zeros are common.
struct Points {
    std::mt19937 random;
    int bits;

    float coordinate()
    {
        const int range = random() % 3 == 0 ? 2 : 1 << bits;
        return float(int(random() % unsigned(2 * range + 1)) - range);
    }
    vec3 point() { return {coordinate(), coordinate(), coordinate()}; }
};

TEST(EdgeSign, IsExactAndDisplaced)
{
    int zeros = 0;
    for (const int bits : {1, 3, 10, 20}) {
        Points points{std::mt19937(unsigned(bits)), bits};
        Effort effort;
        for (int round = 0; round < 20000; ++round) {
            const vec3 a = points.point(), d = points.point();
            const vec3 b = round % 4 ? points.point() : 2.0f * a - d; // in d's plane
            EXPECT_EQ(edge_sign(a, b, d, effort), displaced_sign(a, b, d));
            EXPECT_EQ(edge_sign(b, a, d, effort), -displaced_sign(a, b, d));
            zeros += dot(exact(d), cross(exact(a), exact(b))) == 0;
        }
    }
    EXPECT_GT(zeros, 1000) << "the exact zeros are what this test is for";
}

TEST(VolumeSign, IsExactAndNotDisplaced)
{
    for (const int bits : {1, 3, 10, 20}) {
        Points points{std::mt19937(unsigned(bits)), bits};
        Effort effort;
        for (int round = 0; round < 20000; ++round) {
            const Corners c{points.point(), points.point(), points.point()};
            EXPECT_EQ(
                volume_sign(c, effort), sign(dot(exact(c[0]), cross(exact(c[1]), exact(c[2])))));
        }
    }
}

TEST(CompareDepth, IsExact)
{
    int ties = 0, order = 0;
    for (const int bits : {1, 2, 3, 4, 17}) {
        Points points{std::mt19937(unsigned(bits)), bits};
        Effort effort;
        for (int round = 0; round < 60000; ++round) {
            const vec3 d{
                float(int(points.random() % 9) - 4), float(int(points.random() % 9) - 4), 1};
            const Corners a{points.point(), points.point(), points.point()};
            const Corners b{points.point(), points.point(), points.point()};
            if (!is_hit(a, d, effort) || !is_hit(b, d, effort)) continue;
            const auto parts = [&](const Corners& c, Integer& det, Integer& volume) {
                const Exact p = exact(c[0]), q = exact(c[1]), r = exact(c[2]);
                det = dot(exact(d), cross(p, q)) + dot(exact(d), cross(q, r)) +
                      dot(exact(d), cross(r, p));
                volume = dot(p, cross(q, r));
                EXPECT_EQ(sign(det), sign(volume)) << "a hit lies in front";
                if (det < 0) det = -det, volume = -volume;
            };
            Integer det_a, volume_a, det_b, volume_b;
            parts(a, det_a, volume_a);
            parts(b, det_b, volume_b);
            const int expected = sign(volume_a * det_b - volume_b * det_a); // t_a - t_b
            EXPECT_EQ(compare_depth(a, b, d, effort), expected);
            EXPECT_EQ(compare_depth(b, a, d, effort), -expected);
            (expected == 0 ? ties : order)++;
        }
    }
    EXPECT_GT(ties, 30);
    EXPECT_GT(order, 1000);
}

TEST(CompareDepth, TellsPlanesApartThatDoublesCannot)
{
    // Two triangles whose planes differ by the last bit of one far corner.
    const vec3 d{0, 0, 1};
    const Corners a{vec3(-1e6f, -1e6f, 1e6f), vec3(1e6f, -1e6f, 1e6f), vec3(0, 1e6f, 1e6f)};
    Corners b = a;
    b[2].z = std::nextafter(b[2].z, 2e6f);
    Effort effort;
    ASSERT_TRUE(is_hit(a, d, effort) && is_hit(b, d, effort));
    EXPECT_EQ(compare_depth(a, b, d, effort), -1);
    EXPECT_EQ(compare_depth(b, a, d, effort), 1);
}

TEST(AreCoplanar, SeesOnePlaneAndNothingElse)
{
    Points points{std::mt19937(5), 6};
    for (int round = 0; round < 2000; ++round) {
        const auto on_plane = [&] {
            const float x = points.coordinate(), y = points.coordinate();
            return vec3(x, y, 3 * x - 2 * y + 700);
        };
        const Corners a{on_plane(), on_plane(), on_plane()};
        Corners b{on_plane(), on_plane(), on_plane()};
        EXPECT_TRUE(are_coplanar(a, b));
        b[1].z = std::nextafter(b[1].z, 1e9f);
        Effort effort;
        if (volume_sign(a, effort) != 0) {
            EXPECT_FALSE(are_coplanar(a, b));
        }
    }
}

TEST(IsHit, RefusesWhatIsNoTriangle)
{
    const float inf = INFINITY, nan = NAN;
    const vec3 d{0, 0, 1};
    Effort effort;
    const Corners good{vec3(-1, -1, 2), vec3(1, -1, 2), vec3(0, 1, 2)};
    EXPECT_TRUE(is_hit(good, d, effort));
    for (const float bad : {inf, -inf, nan, 1e30f, -2e30f}) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            for (int axis = 0; axis < 3; ++axis) {
                Corners c = good;
                c[corner][axis] = bad;
                EXPECT_FALSE(is_hit(c, d, effort));
            }
        }
    }
    EXPECT_FALSE(is_hit({good[0], good[0], good[1]}, d, effort));
    EXPECT_FALSE(is_hit({good[0], good[1], 0.5f * (good[0] + good[1])}, d, effort));
}

TEST(IsHit, IsRightAtTheEndsOfTheRange)
{
    Effort effort;
    for (const float scale : {1e-38f, 1e-20f, 1e-3f, 1.0f, 1e6f, 1e20f, 4e29f}) {
        const Corners c{vec3(-1, -1, 2) * scale, vec3(1, -1, 2) * scale, vec3(0, 1, 2) * scale};
        EXPECT_TRUE(is_hit(c, {0, 0, 1}, effort)) << scale;
        EXPECT_TRUE(is_hit(c, {0, -0.499f, 1}, effort)) << scale;
        EXPECT_FALSE(is_hit(c, {0, -0.501f, 1}, effort)) << scale;
        EXPECT_FALSE(is_hit(c, {0, 0, -1}, effort)) << "behind, " << scale;
        EXPECT_NEAR(hit_depth(c, {0, 0, 1}) / (2.0 * scale), 1, 1e-12);
        EXPECT_NEAR(exact_inverse_depth(c, {0, 0, 1}) * 2 * scale, 1, 1e-6);
    }
}

TEST(IsHit, DoesNotCareAboutTheOrderOfTheCorners)
{
    Points points{std::mt19937(9), 3};
    Effort effort;
    for (int round = 0; round < 5000; ++round) {
        Corners c{points.point(), points.point(), points.point()};
        const vec3 d{float(int(points.random() % 5) - 2), float(int(points.random() % 5) - 2), 1};
        const bool expected = is_hit(c, d, effort);
        for (int k = 0; k < 5; ++k) {
            std::shuffle(c.begin(), c.end(), points.random);
            EXPECT_EQ(is_hit(c, d, effort), expected);
        }
    }
}

// Reports of other ray tracers.

TEST(IsHit, FindsNoPhantomOnAHugeFlatBox)
{
    // A box 5.9e11 wide and 1.2e5 high; a ray from above its side, straight down, outside it.
    const float half = 2.95e11f;
    const vec3 eye{half * 1.0001f, 3e5f, 0};
    Effort effort;
    int hits = 0;
    const vec3 corner[8] = {{-half, 0, -half}, {half, 0, -half}, {half, 0, half}, {-half, 0, half},
        {-half, 1.2e5f, -half}, {half, 1.2e5f, -half}, {half, 1.2e5f, half}, {-half, 1.2e5f, half}};
    const int faces[12][3] = {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}, {0, 4, 5}, {0, 5, 1},
        {1, 5, 6}, {1, 6, 2}, {2, 6, 7}, {2, 7, 3}, {3, 7, 4}, {3, 4, 0}};
    for (const auto& f : faces)
        hits += is_hit(
            {corner[f[0]] - eye, corner[f[1]] - eye, corner[f[2]] - eye}, {0, -1, 0}, effort);
    EXPECT_EQ(hits, 0);
}

TEST(IsHit, MissesASkinnyTriangleThatTheRayIsNearlyParallelTo)
{
    // Edges of about 11.2, 9.7 and 1.4; the ray runs 0.52 degrees above its plane and passes it.
    const Corners c{vec3(0, 0, 5), vec3(11.2f, 0, 5), vec3(9.6f, 1.35f, 5)};
    Effort effort;
    const float slope = 0.0090756f; // tan 0.52 degrees
    EXPECT_FALSE(is_hit(c, {1, 0.2f, slope * 0.2f}, effort));
    EXPECT_FALSE(is_hit(c, {1, -0.001f, 0.4f}, effort));
    EXPECT_TRUE(is_hit(c, {1, 0.05f, 0.6f}, effort));
}

} // namespace
} // namespace firsthit
