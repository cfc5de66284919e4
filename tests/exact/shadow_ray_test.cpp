// shadow_ray_test.cpp - the definition of a shadow against whole numbers of any size.
#include "exact/shadow_ray.h"

#include "exact/big_integer.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <random>

namespace firsthit::test {
namespace {

using glm::vec3;
using Big = BigInteger;
using BigPoint = std::array<Big, 3>;

BigPoint exact(const vec3& p)
{
    return {Big::of_float(p.x), Big::of_float(p.y), Big::of_float(p.z)};
}

BigPoint operator-(const BigPoint& a, const BigPoint& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

BigPoint cross(const BigPoint& a, const BigPoint& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Big dot(const BigPoint& a, const BigPoint& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Big size_of(const Big& a)
{
    return a.sign() < 0 ? Big() - a : a;
}

/// Of ray . (a x b), then of what an infinitesimal displacement of the ray adds.
int displaced_sign(const BigPoint& a, const BigPoint& b, const BigPoint& ray)
{
    const BigPoint n = cross(a, b);
    for (const Big& term : {dot(ray, n), n[0], n[1], n[2]})
        if (const int sign = term.sign()) return sign;
    return 0;
}

int expected_side(const PencilSpace& space, const Corners& c)
{
    std::array<BigPoint, 3> p{exact(c[0]), exact(c[1]), exact(c[2])};
    if (space.directional)
        for (BigPoint& q : p) q[2] = Big::of_float(1);
    return dot(p[0], cross(p[1], p[2])).sign();
}

/// The definition once more: nothing is shared with the library but the margins.
bool expected_shadow(const PencilSpace& space, const Corners& c, const vec3& d)
{
    const int side = expected_side(space, c);
    if (side == 0) return false;
    BigPoint ray = exact(d);
    std::array<BigPoint, 3> p{exact(c[0]), exact(c[1]), exact(c[2])};
    const BigPoint n = cross(p[1] - p[0], p[2] - p[0]);
    const Big behind = dot(n, ray - p[0]);
    const Big margin = Big::of_float(shadow_margin(space, d)) + Big::of_float(corner_margin(c));
    const Big length = size_of(n[0]) + size_of(n[1]) + size_of(n[2]);
    if (space.directional)
        for (BigPoint* q : {&ray, &p[0], &p[1], &p[2]}) (*q)[2] = Big::of_float(1);
    for (std::size_t k = 0; k < 3; ++k)
        if (displaced_sign(p[k], p[(k + 1) % 3], ray) != side) return false;
    return ((side > 0 ? behind : Big() - behind) - margin * length).sign() > 0;
}

/// Points of few bits, so that planes, edges and vertices are met exactly; scaled.
struct Points {
    std::mt19937 random;
    int range = 1;
    float scale = 1;

    float whole(int half) { return float(int(random() % unsigned(2 * half + 1)) - half); }
    vec3 point()
    {
        const int half = random() % 3 == 0 ? 1 : range;
        return vec3(whole(half), whole(half), whole(half)) * scale;
    }
};

PencilSpace random_space(std::mt19937& random)
{
    PencilSpace space;
    space.directional = random() % 3 == 0;
    return space;
}

/// Counts what a test has met, so that it cannot pass by meeting nothing.
struct Met {
    int shadowed = 0, lit = 0, exact = 0;

    void check(const PencilSpace& space, const Corners& c, const vec3& d)
    {
        Effort effort;
        const bool expected = expected_shadow(space, c, d);
        ASSERT_EQ(is_shadowed(space, c, d, effort), expected)
            << (space.directional ? "directional " : "point ") << c[0].x << "," << c[0].y << ","
            << c[0].z << " " << c[1].x << "," << c[1].y << "," << c[1].z << " " << c[2].x << ","
            << c[2].y << "," << c[2].z << " d " << d.x << "," << d.y << "," << d.z;
        ASSERT_EQ(light_side(space, c, effort), expected_side(space, c));
        ++(expected ? shadowed : lit);
        exact += effort.exact_calls > 0;
    }
};

TEST(IsShadowed, IsExactForPointsOfFewBits)
{
    for (const float scale : {0x1p-149f, 0x1p-140f, 0x1p-70f, 0x1p-10f, 1.0f, 0x1p20f, 0x1p90f}) {
        Met met;
        for (const int range : {2, 5, 300}) {
            Points points{std::mt19937(unsigned(range)), range, scale};
            for (int round = 0; round < 2500 && !testing::Test::HasFailure(); ++round) {
                const PencilSpace space = random_space(points.random);
                const Corners c{points.point(), points.point(), points.point()};
                met.check(space, c, points.point());
                met.check(space, c, points.random() % 2 ? c[0] : 2.0f * c[1]); // through a vertex
                met.check(space, c, c[0] + c[1]);                              // through an edge
            }
        }
        EXPECT_GT(met.shadowed, 300) << scale;
        EXPECT_GT(met.lit, 300) << scale;
        EXPECT_GT(met.exact, 100) << scale;
    }
}

TEST(IsShadowed, IsExactForAnyFloats)
{
    Met met;
    std::mt19937 random(7);
    const auto coordinate = [&](float middle) {
        std::uniform_real_distribution<float> part(-2, 2), power(-140, 90);
        return random() % 8 ? middle * part(random) : std::exp2(power(random)) * part(random);
    };
    for (int round = 0; round < 30000 && !testing::Test::HasFailure(); ++round) {
        const float middle = std::exp2(std::uniform_real_distribution<float>(-140, 90)(random));
        const auto point = [&] {
            return vec3(coordinate(middle), coordinate(middle), coordinate(middle));
        };
        const Corners c{point(), point(), point()};
        const std::uniform_real_distribution<float> part(0, 1);
        const auto weight = [&] { return std::uniform_real_distribution<float>(0, 1)(random); };
        const vec3 inside = weight() * c[0] + weight() * c[1] + weight() * c[2];
        if (!usable(c) || !usable(inside)) continue;
        met.check(random_space(random), c, inside);
        met.check(random_space(random), c, point());
    }
    EXPECT_GT(met.shadowed, 1000);
    EXPECT_GT(met.lit, 1000);
}

TEST(IsShadowed, IsExactOnThePlaneAndWithinRoundingOfIt)
{
    Met met;
    std::mt19937 random(8);
    std::uniform_real_distribution<float> part(0, 1), across(-1, 1);
    for (int round = 0; round < 20000 && !testing::Test::HasFailure(); ++round) {
        const auto point = [&] { return vec3(across(random), across(random), 3 + across(random)); };
        const Corners c{point(), point(), point()};
        float u = part(random), v = part(random);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        vec3 d = c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]);
        // The margins are 2^-21 times two or three times the size: straddle them by the light's ray.
        const PencilSpace space = random_space(random);
        const vec3 along = space.directional ? vec3(0, 0, 1) : d;
        d += along * (0x1p-21f * 12 * part(random));
        met.check(space, c, d);
    }
    EXPECT_GT(met.shadowed, 1000);
    EXPECT_GT(met.lit, 1000);
}

TEST(IsShadowed, NeedsMoreThanTheMarginsExactly)
{
    Effort effort;
    for (const bool directional : {false, true}) {
        for (const float scale : {0x1p-60f, 1.0f, 0x1p40f}) {
            // The plane z = 4 and the point (0, 0, 4 + k): the margins together are k.
            const Corners c{
                vec3(-1, -1, 4) * scale, vec3(2, -1, 4) * scale, vec3(-1, 2, 4) * scale};
            for (const int k : {1, 2, 3}) {
                const vec3 d = vec3(0, 0, float(4 + k)) * scale;
                PencilSpace space;
                space.directional = directional;
                space.reach = (float(k) * 0x1p21f - 4 - 2 * (4 + float(k))) * scale;
                ASSERT_EQ(
                    double(shadow_margin(space, d)) + double(corner_margin(c)), float(k) * scale);
                EXPECT_FALSE(is_shadowed(space, c, d, effort)) << k << " " << scale;
                EXPECT_FALSE(is_shadowed(space, {c[0], c[2], c[1]}, d, effort));
                space.reach = std::nextafter(space.reach, 0.0f);
                EXPECT_TRUE(is_shadowed(space, c, d, effort)) << k << " " << scale;
                EXPECT_TRUE(is_shadowed(space, {c[0], c[2], c[1]}, d, effort));
            }
        }
    }
}

TEST(IsShadowed, IsNotDoneByTrianglesInTheLightsPlaneNorBehindThePoint)
{
    Effort effort;
    PencilSpace point, parallel;
    parallel.directional = true;
    EXPECT_FALSE(
        is_shadowed(point, {vec3(-1, 0, 1), vec3(1, 0, 1), vec3(0, 0, 3)}, {0, 0, 9}, effort));
    EXPECT_FALSE(is_shadowed(point, {vec3(0), vec3(1, 0, 1), vec3(0, 1, 1)}, {1, 1, 9}, effort));
    EXPECT_FALSE(
        is_shadowed(parallel, {vec3(-1, 0, 1), vec3(1, 0, 1), vec3(0, 0, 3)}, {0, 0, 9}, effort));
    const Corners c{vec3(-1, -1, 2), vec3(1, -1, 2), vec3(0, 1, 2)};
    for (const PencilSpace& space : {point, parallel}) {
        EXPECT_TRUE(is_shadowed(space, c, {0, 0, 3}, effort));
        EXPECT_FALSE(is_shadowed(space, c, {0, 0, 2}, effort)) << "on it";
        EXPECT_FALSE(is_shadowed(space, c, {0, 0, 1}, effort)) << "before it";
    }
    EXPECT_FALSE(is_shadowed(point, c, {0, 0, -3}, effort)) << "on the light's other side";
    EXPECT_FALSE(is_shadowed(parallel, c, {0, 0, -3}, effort)) << "before it";
    // A light from infinitely far away also meets what lies at negative z.
    EXPECT_TRUE(is_shadowed(parallel, {c[0] - vec3(0, 0, 9), c[1], c[2]}, {0, 0, 3}, effort));
}

TEST(IsShadowed, IsNeverTrueOfWhatHasNoRayOrIsNoTriangle)
{
    Effort effort;
    const Corners c{vec3(-1, -1, 2), vec3(1, -1, 2), vec3(0, 1, 2)};
    for (const bool directional : {false, true}) {
        PencilSpace space;
        space.directional = directional;
        for (const float bad : {INFINITY, -INFINITY, NAN, 1e30f, -2e30f}) {
            for (int axis = 0; axis < 3; ++axis) {
                vec3 d(0, 0, 3);
                d[axis] = bad;
                EXPECT_FALSE(is_shadowed(space, c, d, effort));
                Corners broken = c;
                broken[1][axis] = bad;
                EXPECT_FALSE(is_shadowed(space, broken, {0, 0, 3}, effort));
                EXPECT_EQ(light_side(space, broken, effort), 0);
            }
        }
        space.reach = INFINITY;
        EXPECT_FALSE(is_shadowed(space, c, {0, 0, 3}, effort));
    }
    EXPECT_FALSE(is_shadowed({}, c, {0, 0, 0}, effort)) << "where the light is";
}

TEST(IsShadowed, DoesNotCareAboutTheOrderOfTheCorners)
{
    Points points{std::mt19937(9), 3, 1};
    Effort effort;
    for (int round = 0; round < 5000; ++round) {
        const PencilSpace space = random_space(points.random);
        Corners c{points.point(), points.point(), points.point()};
        const vec3 d = points.point();
        const bool expected = is_shadowed(space, c, d, effort);
        for (int k = 0; k < 5; ++k) {
            std::shuffle(c.begin(), c.end(), points.random);
            EXPECT_EQ(is_shadowed(space, c, d, effort), expected);
        }
    }
}

TEST(LightSpaceOf, ADirectionalLightHasARotationThatEndsInItsDirection)
{
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int round = 0; round < 200; ++round) {
        Light light;
        light.kind = Light::Kind::directional;
        light.direction = {normal(random), normal(random), normal(random)};
        if (round < 6)
            light.direction = glm::dvec3(0), light.direction[round / 2] = round % 2 ? 1 : -1;
        const double length = std::pow(10.0, round % 7 * 100 - 300);
        const glm::dvec3 way = glm::normalize(light.direction);
        light.direction *= length; // any length
        const PencilSpace space = light_space(light, {0, 0, 0});
        EXPECT_LT(glm::length(space.axes * way - glm::dvec3(0, 0, 1)), 1e-14) << length;
        const glm::dmat3 unit = space.axes * glm::transpose(space.axes);
        for (int k = 0; k < 3; ++k)
            for (int j = 0; j < 3; ++j) EXPECT_NEAR(unit[k][j], k == j ? 1 : 0, 1e-14);
        EXPECT_NEAR(
            glm::dot(glm::cross(glm::transpose(space.axes)[0], glm::transpose(space.axes)[1]), way),
            1, 1e-14);
    }
}

TEST(LightSpaceOf, ADirectionAlongAnAxisRoundsNothing)
{
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            Light light;
            light.kind = Light::Kind::directional;
            light.direction = glm::dvec3(0);
            light.direction[axis] = 0.3 * sign;
            const vec3 p(1.1f, -2.3f, 1e-7f), d = to_light(light_space(light, {}), p);
            std::array<float, 3> before{1.1f, 2.3f, 1e-7f};
            std::array<float, 3> after{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
            std::sort(before.begin(), before.end());
            std::sort(after.begin(), after.end());
            EXPECT_EQ(before, after);
            EXPECT_EQ(d.z, float(sign) * p[axis]);
        }
    }
}

TEST(Lifted, APointRisesTowardsTheLightByHalfItsMargins)
{
    Effort effort;
    std::mt19937 random(4);
    std::uniform_real_distribution<float> across(-1, 1), part(0, 1);
    for (int round = 0; round < 3000; ++round) {
        const PencilSpace space = random_space(random);
        const auto point = [&] { return vec3(across(random), across(random), 3 + across(random)); };
        const Corners c{point(), point(), point()};
        const vec3 d =
            c[0] + part(random) * 0.5f * (c[1] - c[0]) + part(random) * 0.5f * (c[2] - c[0]);
        const int side = light_side(space, c, effort);
        const vec3 up = lifted(space, d, receiver_of(c, side));
        const glm::dvec3 n = glm::normalize(
            glm::cross(glm::dvec3(c[1]) - glm::dvec3(c[0]), glm::dvec3(c[2]) - glm::dvec3(c[0])));
        const double rise = -side * glm::dot(n, glm::dvec3(up) - glm::dvec3(d));
        const double half = 0.5 * (double(shadow_margin(space, d)) + double(corner_margin(c)));
        EXPECT_GT(rise, half * 0.8);
        EXPECT_LT(rise, half * 2.0);
        EXPECT_EQ(lifted(space, d, receiver_of(c, 0)), d);
    }
    EXPECT_EQ(receiver_of({vec3(1), vec3(1), vec3(1)}, 1).away, vec3(0)) << "no plane";
}

} // namespace
} // namespace firsthit::test
