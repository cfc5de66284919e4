// evaluate_channel_test.cpp - step, linear and cubic channels.
#include "scene/animate/evaluate_channel.h"

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace firsthit {
namespace {

using Path = Channel::Path;
using Interpolation = Channel::Interpolation;

Channel channel(
    Path path, Interpolation interpolation, std::vector<double> times, std::vector<double> values)
{
    Channel made;
    made.path = path;
    made.interpolation = interpolation;
    made.time_s = std::move(times);
    made.value = std::move(values);
    return made;
}

std::array<double, 4> at(const Channel& channel, double time_s)
{
    std::array<double, 4> value{};
    evaluate(channel, time_s, std::span(value).first(components_of(channel)));
    return value;
}

TEST(EvaluateChannel, HoldsTheFirstAndLastKeyOutside)
{
    for (const Interpolation how : {Interpolation::step, Interpolation::linear}) {
        const Channel c = channel(Path::translation, how, {2, 3}, {1, 2, 3, 4, 5, 6});
        EXPECT_EQ(at(c, 0), (std::array<double, 4>{1, 2, 3, 0}));
        EXPECT_EQ(at(c, 2), (std::array<double, 4>{1, 2, 3, 0}));
        EXPECT_EQ(at(c, 3), (std::array<double, 4>{4, 5, 6, 0}));
        EXPECT_EQ(at(c, 9), (std::array<double, 4>{4, 5, 6, 0}));
    }
}

TEST(EvaluateChannel, StepsAtTheKeyAndNotBefore)
{
    const Channel c =
        channel(Path::scale, Interpolation::step, {0, 1, 2}, {1, 1, 1, 2, 2, 2, 3, 3, 3});
    EXPECT_EQ(at(c, std::nextafter(1.0, 0.0))[0], 1);
    EXPECT_EQ(at(c, 1)[0], 2);
    EXPECT_EQ(at(c, 1.99)[0], 2);
}

TEST(EvaluateChannel, IsALineBetweenLinearKeys)
{
    const Channel c =
        channel(Path::translation, Interpolation::linear, {1, 3}, {0, 10, -4, 8, 10, 4});
    EXPECT_EQ(at(c, 1.5), (std::array<double, 4>{2, 10, -2, 0}));
}

TEST(EvaluateChannel, OneKeyIsAConstant)
{
    const Channel c = channel(Path::translation, Interpolation::linear, {5}, {1, 2, 3});
    for (const double t : {0.0, 5.0, 9.0}) EXPECT_EQ(at(c, t), (std::array<double, 4>{1, 2, 3, 0}));
}

TEST(EvaluateChannel, TwoKeysAtOneTimeAreAJump)
{
    const Channel c = channel(Path::translation, Interpolation::linear, {0, 1, 1, 2},
        {0, 0, 0, 1, 0, 0, 5, 0, 0, 6, 0, 0});
    EXPECT_EQ(at(c, 1)[0], 5);
    EXPECT_NEAR(at(c, 1 - 1e-9)[0], 1, 1e-8);
}

TEST(EvaluateChannel, TurnsAtConstantSpeedTheShortWay)
{
    const double s = std::sqrt(0.5);
    // The second quaternion is the opposite of a quarter turn: the same turn.
    const Channel c =
        channel(Path::rotation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 0, 0, -s, -s});
    for (const double u : {0.1, 0.25, 0.5, 0.9}) {
        const auto q = at(c, u);
        const double angle = 2 * std::atan2(q[2], q[3]);
        EXPECT_NEAR(std::remainder(angle, 2 * 3.14159265358979323846),
            u * 3.14159265358979323846 / 2, 1e-12);
    }
}

TEST(EvaluateChannel, NormalisesKeysBeforeItTurnsBetweenThem)
{
    const double s = std::sqrt(0.5);
    const Channel unit =
        channel(Path::rotation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 0, 0, s, s});
    const Channel longer = channel(
        Path::rotation, Interpolation::linear, {0, 1}, {0, 0, 0, 3, 0, 0, 0.1 * s, 0.1 * s});
    for (const double u : {0.0, 0.3, 1.0})
        for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(at(unit, u)[k], at(longer, u)[k], 1e-14);
}

TEST(EvaluateChannel, HasTheTangentsOfACubicSpline)
{
    // Arrives, value, leaves. Per second, over two seconds.
    const Channel c = channel(Path::translation, Interpolation::cubic, {0, 2},
        {9, 9, 9, 1, 2, 3, 0.5, -1, 0, 2, 0, 0, 5, 5, 5, 9, 9, 9});
    const double h = 1e-6;
    EXPECT_EQ(at(c, 0)[0], 1);
    EXPECT_EQ(at(c, 2)[1], 5);
    EXPECT_NEAR((at(c, h)[0] - at(c, 0)[0]) / h, 0.5, 1e-4);
    EXPECT_NEAR((at(c, h)[1] - at(c, 0)[1]) / h, -1, 1e-4);
    EXPECT_NEAR((at(c, 2)[0] - at(c, 2 - h)[0]) / h, 2, 1e-4);
}

TEST(EvaluateChannel, NormalisesACubicRotationAfterwards)
{
    const Channel c = channel(Path::rotation, Interpolation::cubic, {0, 1},
        {0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0});
    for (const double u : {0.0, 0.2, 0.5, 0.77, 1.0}) {
        const auto q = at(c, u);
        EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1, 1e-14);
    }
}

TEST(EvaluateChannel, HasAsManyWeightsAsAKey)
{
    const Channel c = channel(Path::weights, Interpolation::linear, {0, 1}, {0, 1, 2, 1, 1, 0});
    EXPECT_EQ(components_of(c), 3u);
    EXPECT_EQ(at(c, 0.5), (std::array<double, 4>{0.5, 1, 1, 0}));
    std::array<double, 2> fewer{};
    evaluate(c, 0.5, fewer);
    EXPECT_EQ(fewer, (std::array<double, 2>{0.5, 1}));
}

} // namespace
} // namespace firsthit
