// track_test.cpp - splines of places, scales and rotations.
#include "scene/animate/evaluate_channel.h"
#include "scene/animate/tcb_spline.h"
#include "scene/animate/track.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace firsthit {
namespace {

TcbKey key(double time_s, const glm::dvec3& value)
{
    return {.time_s = time_s, .value = glm::dvec4(value, 0)};
}

TcbKey turn(double time_s, const glm::dvec3& axis, double angle_deg)
{
    const double half = glm::radians(angle_deg) / 2;
    return {.time_s = time_s,
        .value = glm::dvec4(glm::normalize(axis) * std::sin(half), std::cos(half))};
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-12)
{
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance);
}

void expect_near(const glm::dmat4& a, const glm::dmat4& b, double tolerance = 1e-12)
{
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) EXPECT_NEAR(a[c][r], b[c][r], tolerance);
}

std::vector<TcbKey> random_keys(unsigned seed, bool rotations)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-1, 1);
    std::vector<TcbKey> keys;
    double time_s = 0;
    for (int k = 0; k < 12; ++k) {
        time_s += 0.1 + std::abs(any(random));
        const glm::dvec3 v(any(random), any(random), any(random));
        keys.push_back(rotations ? turn(time_s, v, 90 * any(random)) : key(time_s, v));
        keys.back().tension = any(random);
        keys.back().continuity = any(random);
        keys.back().bias = any(random);
    }
    return keys;
}

TEST(Track, PassesThroughItsKeysWhateverTheirShape)
{
    for (unsigned seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        const std::vector<TcbKey> keys = random_keys(seed, false);
        for (std::size_t k = 1; k + 1 < keys.size(); ++k)
            expect_near(evaluate_vector(keys, keys[k].time_s), glm::dvec3(keys[k].value));
    }
}

TEST(Track, ReachesItsKeysFromBothSides)
{
    for (unsigned seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        const std::vector<TcbKey> keys = random_keys(seed, false);
        for (std::size_t k = 1; k + 1 < keys.size(); ++k)
            for (const double side : {-1e-9, 1e-9})
                expect_near(
                    evaluate_vector(keys, keys[k].time_s + side), glm::dvec3(keys[k].value), 1e-6);
    }
}

TEST(Track, TurnsThroughItsKeysFromBothSides)
{
    for (unsigned seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        const std::vector<TcbKey> keys = random_keys(seed, true);
        for (std::size_t k = 1; k + 1 < keys.size(); ++k)
            for (const double side : {-1e-6, 0.0, 1e-6}) {
                const glm::dquat q = evaluate_rotation(keys, keys[k].time_s + side);
                // q and -q are the same rotation. slerp stands still within 1e-3 of its ends.
                const double same = glm::dot(glm::dvec4(q.x, q.y, q.z, q.w), keys[k].value);
                EXPECT_NEAR(std::abs(same), 1, 1e-5);
            }
    }
}

TEST(Track, StandsStillBeforeTheSecondAndAfterTheLastButOneKey)
{
    const std::vector<TcbKey> keys = {
        key(0, {9, 9, 9}), key(1, {1, 2, 3}), key(2, {4, 5, 6}), key(3, {9, 9, 9})};
    for (const double t : {-100.0, 0.0, 0.5, 1.0})
        EXPECT_EQ(evaluate_vector(keys, t), glm::dvec3(1, 2, 3));
    for (const double t : {2.0, 2.5, 3.0, 100.0})
        EXPECT_EQ(evaluate_vector(keys, t), glm::dvec3(4, 5, 6));
}

TEST(Track, IsCatmullRomWithEqualSpacingAndNoShape)
{
    // At the middle of a piece: (-a + 9 b + 9 c - d) / 16.
    const std::vector<TcbKey> keys = {
        key(0, {1, 0, 0}), key(1, {2, 1, 0}), key(2, {5, 0, 3}), key(3, {-4, 7, 0})};
    expect_near(evaluate_vector(keys, 1.5), (-glm::dvec3(1, 0, 0) + 9.0 * glm::dvec3(2, 1, 0) +
                                                9.0 * glm::dvec3(5, 0, 3) - glm::dvec3(-4, 7, 0)) /
                                                16.0);
}

TEST(Track, IsALineWhenKeysLieOnOneEvenlyOrNot)
{
    const std::vector<TcbKey> keys = {key(0, {0, 0, 0}), key(1, {1, 0, 0}), key(1.5, {1.5, 0, 0}),
        key(4, {4, 0, 0}), key(4.5, {4.5, 0, 0})};
    for (double t = 1; t <= 4; t += 0.125) expect_near(evaluate_vector(keys, t), {t, 0, 0});
}

TEST(Track, GoesStraightWithFullTension)
{
    // No tangents: from key to key along the line, slow at its ends.
    std::vector<TcbKey> keys = {
        key(0, {7, 7, 7}), key(1, {0, 0, 0}), key(2, {2, 4, 6}), key(3, {-7, -7, -7})};
    for (TcbKey& k : keys) k.tension = 1;
    expect_near(evaluate_vector(keys, 1.5), {1, 2, 3});
    expect_near(evaluate_vector(keys, 1.25), glm::dvec3(2, 4, 6) * (3 * 0.0625 - 2 * 0.015625));
}

TEST(Track, HasItsOutgoingTangentFromContinuityAndBias)
{
    // With (1 - T)(1 + C)(1 + B) / 2 and (1 - T)(1 - C)(1 - B) / 2 of the steps before and after.
    std::vector<TcbKey> keys = {
        key(0, {0, 0, 0}), key(1, {1, 0, 0}), key(2, {1, 3, 0}), key(3, {1, 3, 0})};
    keys[1].tension = 0.5;
    keys[1].continuity = 0.25;
    keys[1].bias = -0.5;
    const double before = 0.5 * 0.5 * 1.25 * 0.5;
    const double after = 0.5 * 0.5 * 0.75 * 1.5;
    const double h = 1e-7;
    expect_near((evaluate_vector(keys, 1 + h) - evaluate_vector(keys, 1)) / h,
        before * glm::dvec3(1, 0, 0) + after * glm::dvec3(0, 3, 0), 1e-5);
}

TEST(Track, HasItsIncomingTangentFromContinuityAndBias)
{
    // With (1 - T)(1 - C)(1 + B) / 2 and (1 - T)(1 + C)(1 - B) / 2.
    std::vector<TcbKey> keys = {
        key(0, {0, 0, 0}), key(1, {0, 0, 0}), key(2, {1, 0, 0}), key(3, {1, 3, 0})};
    keys[2].tension = 0.5;
    keys[2].continuity = 0.25;
    keys[2].bias = -0.5;
    const double before = 0.5 * 0.5 * 0.75 * 0.5;
    const double after = 0.5 * 0.5 * 1.25 * 1.5;
    const double h = 1e-7;
    expect_near((evaluate_vector(keys, 2) - evaluate_vector(keys, 2 - h)) / h,
        before * glm::dvec3(1, 0, 0) + after * glm::dvec3(0, 3, 0), 1e-5);
}

TEST(Track, SurvivesKeysAtTheSameTime)
{
    const std::vector<TcbKey> keys = {key(0, {1, 0, 0}), key(0, {1, 0, 0}), key(1, {2, 0, 0}),
        key(1, {5, 0, 0}), key(2, {6, 0, 0}), key(2, {6, 0, 0})};
    for (double t = -1; t <= 3; t += 0.125)
        EXPECT_TRUE(std::isfinite(evaluate_vector(keys, t).x)) << t;
    EXPECT_EQ(evaluate_vector(keys, 1).x, 5) << "the piece without length is never taken";
    EXPECT_LE(evaluate_vector(keys, 0.999).x, 2.5);
}

TEST(Track, HoldsWhereAllKeysAreAtTheSameTime)
{
    const std::vector<TcbKey> keys(4, key(1, {1, 2, 3}));
    for (const double t : {0.0, 1.0, 2.0}) EXPECT_EQ(evaluate_vector(keys, t), glm::dvec3(1, 2, 3));
}

TEST(Track, TakesTheFirstPieceThatEndsLaterWhereTimeGoesBack)
{
    // 0 1 2 [back to 1.5] 3 4: times in (1, 2) belong to the piece before the step back.
    std::vector<TcbKey> keys = {key(0, {0, 0, 0}), key(1, {1, 0, 0}), key(2, {2, 0, 0}),
        key(1.5, {50, 0, 0}), key(3, {60, 0, 0}), key(4, {70, 0, 0})};
    for (TcbKey& k : keys) k.tension = 1;
    EXPECT_LE(evaluate_vector(keys, 1.75).x, 2);
    EXPECT_GE(evaluate_vector(keys, 2.25).x, 50);
    for (double t = 0; t <= 4; t += 0.0625)
        EXPECT_TRUE(std::isfinite(evaluate_vector(keys, t).x)) << t;
}

TEST(Track, HoldsTheSecondKeyWhereThereAreFewerThanFour)
{
    std::vector<TcbKey> keys = {key(0, {1, 1, 1})};
    EXPECT_EQ(evaluate_vector(keys, 5), glm::dvec3(1));
    keys.push_back(key(1, {2, 2, 2}));
    EXPECT_EQ(evaluate_vector(keys, 0), glm::dvec3(2));
    keys.push_back(key(2, {3, 3, 3}));
    EXPECT_EQ(evaluate_vector(keys, 9), glm::dvec3(2));
    EXPECT_NEAR(evaluate_rotation({turn(0, {0, 0, 1}, 90)}, 3).z, std::sqrt(0.5), 1e-15);
}

TEST(Track, TurnsEvenlyAboutOneAxis)
{
    std::vector<TcbKey> keys;
    for (int k = 0; k < 6; ++k) keys.push_back(turn(k, {0, 1, 0}, 40 * k));
    for (double t = 1; t <= 4; t += 0.25) {
        const glm::dquat q = evaluate_rotation(keys, t);
        EXPECT_NEAR(2 * std::atan2(q.y, q.w), glm::radians(40 * t), 1e-9);
    }
}

TEST(Track, TurnsTheShortWay)
{
    // The same rotations, with the quaternion of one key negated.
    std::vector<TcbKey> keys, negated;
    for (int k = 0; k < 7; ++k) keys.push_back(turn(k, {1, 1, 0}, 20 * k));
    negated = keys;
    negated[2].value = -negated[2].value;
    for (double t = 2.0; t <= 5; t += 0.125) {
        if (t < 3) continue; // around the key itself tangents follow BART's own code
        const glm::dquat p = evaluate_rotation(keys, t);
        const glm::dquat q = evaluate_rotation(negated, t);
        EXPECT_NEAR(std::abs(glm::dot(p, q)), 1, 1e-12) << t;
    }
}

TEST(Track, TurnsManyTimesInStepsOfNinetyDegrees)
{
    std::vector<TcbKey> keys;
    for (int k = 0; k < 100; ++k) keys.push_back(turn(k, {0, 0, 1}, 90 * k));
    Track track;
    track.rotation = keys;
    for (const double t : {1.0, 37.0, 50.5, 90.25}) {
        const double angle = glm::radians(90 * t);
        expect_near(glm::dvec3(matrix_of(transform_at(track, t))[0]),
            {std::cos(angle), std::sin(angle), 0}, 1e-6);
    }
}

TEST(Track, MakesTranslationTimesRotationTimesScale)
{
    Track track;
    track.translation.assign(4, key(0, {1, 2, 3}));
    track.rotation.assign(4, turn(0, {0, 0, 1}, 90));
    track.scale.assign(4, key(0, {2, 3, 4}));
    const glm::dmat4 t = glm::translate(glm::dmat4(1), glm::dvec3(1, 2, 3));
    const glm::dmat4 r = glm::rotate(glm::dmat4(1), glm::radians(90.0), glm::dvec3(0, 0, 1));
    const glm::dmat4 s = glm::scale(glm::dmat4(1), glm::dvec3(2, 3, 4));
    expect_near(matrix_of(transform_at(track, 0)), t * r * s);
    track.rotation.clear();
    expect_near(matrix_of(transform_at(track, 0)), t * s);
    EXPECT_EQ(matrix_of(transform_at(Track(), 0)), glm::dmat4(1));
}

TEST(Track, IsVisibleInSteps)
{
    Track track;
    track.visibility = {{1, false}, {2, true}, {2, false}, {3, true}};
    Clip clip;
    add_channels(track, 7, clip);
    ASSERT_EQ(clip.channels.size(), 1u);
    EXPECT_EQ(clip.channels[0].node, 7u);
    const auto visible = [&](double t) {
        double value = -1;
        evaluate(clip.channels[0], t, {&value, 1});
        return value;
    };
    EXPECT_EQ(visible(0.99), 1);
    EXPECT_EQ(visible(1), 0);
    EXPECT_EQ(visible(2.5), 0) << "the later of two steps at one time";
    EXPECT_EQ(visible(3), 1);
}

TEST(Track, BecomesOneChannelForEachPropertyThatItMoves)
{
    Track track;
    track.translation.assign(4, key(0, {7, 8, 9}));
    track.scale.assign(4, key(0, {1, 2, 3}));
    Clip clip;
    add_channels(track, 3, clip);
    ASSERT_EQ(clip.channels.size(), 2u);
    EXPECT_EQ(clip.channels[0].path, Channel::Path::translation);
    EXPECT_EQ(clip.channels[1].path, Channel::Path::scale);
    for (const Channel& channel : clip.channels) {
        EXPECT_EQ(channel.node, 3u);
        EXPECT_EQ(channel.interpolation, Channel::Interpolation::tcb);
        EXPECT_EQ(channel.tcb.size(), 4u);
    }
}

} // namespace
} // namespace firsthit
