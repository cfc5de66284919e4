// spot_cone_test.cpp - which directions a spot's light takes.
#include "hits/spot_cone.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace firsthit {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

SpotCone cone_of(const glm::dvec3& direction, double inner_rad, double outer_rad)
{
    return spot_cone({.kind = Light::Kind::spot,
        .direction = direction,
        .inner_rad = inner_rad,
        .outer_rad = outer_rad});
}

/// A direction at an angle to -y.
glm::vec3 off_axis(double angle_rad, double turn_rad = 0.3)
{
    return glm::vec3(std::sin(angle_rad) * std::cos(turn_rad), -std::cos(angle_rad),
        std::sin(angle_rad) * std::sin(turn_rad));
}

TEST(SpotCone, FadesAsSmoothstepOfTheCosine)
{
    const double inner = 10 * kDegree, outer = 40 * kDegree;
    const SpotCone cone = cone_of({0, -3, 0}, inner, outer);
    for (double angle = 0; angle < 60 * kDegree; angle += kDegree) {
        const double s = (std::cos(angle) - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
        const double c = std::min(std::max(s, 0.0), 1.0);
        EXPECT_NEAR(spot_share(cone, off_axis(angle)), c * c * (3 - 2 * c), 2e-6) << angle;
    }
}

TEST(SpotCone, EndsAtItsAngleHoweverNarrowOrWide)
{
    for (const double degrees : {1e-3, 0.01, 1.0, 30.0, 60.0, 89.0}) {
        const double outer = degrees * kDegree;
        const SpotCone cone = cone_of({0, -1, 0}, outer / 2, outer);
        for (double turn = 0; turn < 6; turn += 0.7) {
            EXPECT_TRUE(in_cone(cone, off_axis(outer * 0.999, turn))) << degrees;
            EXPECT_FALSE(in_cone(cone, off_axis(outer * 1.001, turn))) << degrees;
            EXPECT_EQ(spot_share(cone, off_axis(outer * 0.499, turn)), 1) << degrees;
            EXPECT_LT(spot_share(cone, off_axis(outer * 0.55, turn)), 1) << degrees;
        }
    }
}

TEST(SpotCone, HasADirectionInsideExactlyWhereItHasLightThere)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> number(-1, 1);
    for (const double outer : {1e-4, 0.3, 0.9, 1.57}) {
        // Close to the border, where roundings decide.
        const SpotCone cone = cone_of({0.3, -1, 0.2}, 0.99 * outer, outer);
        const glm::vec3 axis = cone.axis;
        const glm::vec3 across = glm::normalize(glm::cross(axis, glm::vec3(1, 0, 0)));
        const double spread = 3e-7 + 2e-7 / outer; // the axis is rounded too
        int inside = 0, outside = 0;
        for (int k = 0; k < 20000; ++k) {
            const float angle = static_cast<float>(outer * (1 + spread * number(random)));
            const glm::vec3 d = axis * std::cos(angle) + across * std::sin(angle);
            EXPECT_EQ(in_cone(cone, d), spot_share(cone, d) > 0);
            ++(in_cone(cone, d) ? inside : outside);
        }
        EXPECT_GT(inside, 0);
        EXPECT_GT(outside, 0);
    }
}

TEST(SpotCone, HasAHardBorderWhereInnerIsOuter)
{
    const SpotCone cone = cone_of({0, -1, 0}, 0.5, 0.5);
    EXPECT_EQ(spot_share(cone, off_axis(0.4999999)), 1);
    EXPECT_EQ(spot_share(cone, off_axis(0.5000001)), 0);
}

TEST(SpotCone, DoesNotDependOnLengths)
{
    const glm::vec3 d = off_axis(0.3);
    for (const double length : {1e-90, 1.0, 1e90})
        for (const float scale : {0x1p-120f, 1.0f, 0x1p100f}) {
            const SpotCone cone = cone_of({0, -length, 0}, 0.1, 0.5);
            EXPECT_EQ(spot_share(cone, d * scale), spot_share(cone_of({0, -1, 0}, 0.1, 0.5), d));
        }
}

TEST(SpotCone, HasNoLightForWhatIsNoDirection)
{
    const SpotCone cone = cone_of({0, -1, 0}, 0.5, 1.5);
    const float inf = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const glm::vec3 d : {glm::vec3(0), glm::vec3(0, -inf, 0), glm::vec3(nan, -1, 0),
             glm::vec3(0, -1, nan), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0), glm::vec3(-inf)}) {
        EXPECT_FALSE(in_cone(cone, d)) << d.x << " " << d.y << " " << d.z;
        EXPECT_EQ(spot_share(cone, d), 0);
    }
}

} // namespace
} // namespace firsthit
