// terminator_test.cpp - how light fades where shadows of flat triangles meet smooth normals.
#include "shade/plain_shade.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace firsthit::test {
namespace {

using scalar::real3;

struct Terminator : testing::Test {
    std::mt19937 random{5};
    std::uniform_real_distribution<float> unit{-1, 1};

    real3 direction() { return scalar::unit(real3(unit(random), unit(random), unit(random))); }

    /// A surface whose smooth normal is off the flat one by an angle of the sine `off`.
    scalar::Surface surface(float off, float bend)
    {
        scalar::Surface made;
        made.flat_normal = direction();
        const real3 across = scalar::unit(scalar::cross_product(made.flat_normal, direction()));
        made.normal = made.flat_normal * std::sqrt(1 - off * off) + across * off;
        made.bend = bend;
        return made;
    }
};

TEST_F(Terminator, FlatSurfacesKeepAllLight)
{
    for (int k = 0; k < 1000; ++k) {
        const scalar::Surface flat = surface(0, 0);
        const real3 l = direction();
        if (dot(flat.normal, l) < 1e-3f) continue;
        ASSERT_EQ(scalar::terminator_share(flat, l), 1.0f);
    }
}

TEST_F(Terminator, AllLightIsKeptAwayFromTheBorder)
{
    for (int k = 0; k < 3000; ++k) {
        const float bend = 0.225f + 0.225f * unit(random);
        const scalar::Surface smooth = surface(bend * std::abs(unit(random)), bend);
        const real3 l = direction();
        if (dot(smooth.normal, l) < 0.75f) continue;
        ASSERT_EQ(scalar::terminator_share(smooth, l), 1.0f) << bend;
    }
}

TEST_F(Terminator, NoLightIsLeftWhereATriangleTurnsAway)
{
    int tested = 0;
    for (int k = 0; k < 20000; ++k) {
        const float bend = 0.225f + 0.225f * unit(random);
        const scalar::Surface smooth = surface(bend * std::abs(unit(random)), bend);
        const real3 l = direction();
        const float flat = dot(smooth.flat_normal, l);
        if (flat > 0 || dot(smooth.normal, l) <= 0) continue;
        ++tested;
        ASSERT_LE(scalar::terminator_share(smooth, l), 1e-5f) << bend;
    }
    EXPECT_GT(tested, 300);
}

TEST_F(Terminator, OnCoarseTrianglesItDependsOnTheSmoothNormalAlone)
{
    const real3 l(0, 0, 1), n = scalar::unit(real3(0.9f, 0, 0.45f));
    scalar::Surface a, b;
    a.normal = b.normal = n;
    a.bend = b.bend = 0.35f;
    a.flat_normal = scalar::unit(real3(1, 0.2f, 0.1f));
    b.flat_normal = scalar::unit(real3(0.8f, -0.2f, 0.6f));
    const float share = scalar::terminator_share(a, l);
    EXPECT_GT(share, 0.1f);
    EXPECT_LT(share, 0.9f);
    EXPECT_NEAR(scalar::terminator_share(b, l), share, 1e-6f);
}

TEST_F(Terminator, ABendIsTheSmallestAngleOfACorner)
{
    const std::vector<glm::vec3> normal{{0, 0.6f, 0.8f}, {0.28f, 0, 0.96f}, {-0.6f, 0, 0.8f}};
    ShadeArrays arrays;
    arrays.normal = normal.data();
    const auto bend = [&](const glm::uvec3& corner, const glm::vec3& to_eye) {
        return run_facing(arrays, corner, to_eye).bend;
    };
    EXPECT_NEAR(bend({0, 1, 2}, {0, 0, 1}), 0.28f, 1e-6f);
    EXPECT_NEAR(bend({0, 1, 2}, {0, 0, -0.5f}), 0.28f, 1e-6f) << "normals are turned";
    EXPECT_FLOAT_EQ(bend({0, 0, 2}, {0, 0, 1}), 0.45f);
    EXPECT_EQ(bend({0, 0, 0}, {1, 0, 0}), 0) << "at right angles";
    EXPECT_LT(bend({1, 1, 1}, {0.28f, 0, 0.96f}), 1e-3f);
    EXPECT_EQ(run_facing(arrays, {0, 1, 2}, {0, 0, -0.5f}).normal, glm::vec3(0, 0, -1));
    EXPECT_EQ(bend({0, 1, 2}, {0, 0, 0}), 0) << "no plane";
}

} // namespace
} // namespace firsthit::test
