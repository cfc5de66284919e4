// quality_test.cpp - what is left out while something moves, and in which order.
#include "view/frames/quality.h"

#include <gtest/gtest.h>

namespace firsthit::cli::view {
namespace {

Settings dear()
{
    Settings settings;
    settings.sky.directions = 24;
    settings.adaptive = 4;
    return settings;
}

TEST(Quality, LeavesOutSkyThenSupersamplingThenRaysThenSize)
{
    const std::vector<Rung> rungs = rungs_of(dear(), true);
    ASSERT_EQ(rungs.size(), 10u);
    EXPECT_EQ(rungs[0].missing, "");
    EXPECT_EQ(rungs[1].missing, "most of the sky");
    EXPECT_GT(rungs[1].settings.sky.directions, 0);
    EXPECT_LT(rungs[1].settings.sky.directions, 24);
    EXPECT_EQ(rungs[2].missing, "sky");
    EXPECT_EQ(rungs[2].settings.sky.directions, 0);
    EXPECT_EQ(rungs[2].settings.adaptive, 4);
    EXPECT_EQ(rungs[3].missing, "sky, supersampling");
    EXPECT_EQ(rungs[4].settings.interleave, 2);
    EXPECT_EQ(rungs[5].settings.interleave, 4);
    EXPECT_EQ(rungs[5].scale, 1);
    for (std::size_t k = 6; k < 10; ++k) EXPECT_LT(rungs[k].scale, rungs[k - 1].scale);
    EXPECT_EQ(rungs[9].missing, "sky, supersampling, pixels");
}

TEST(Quality, StepsThatLeaveOutNothingAreNotThere)
{
    const std::vector<Rung> rungs = rungs_of(Settings{}, false);
    ASSERT_EQ(rungs.size(), 5u); // whole, and four sizes
    EXPECT_LT(rungs[1].scale, 1);
    for (const Rung& rung : rungs) EXPECT_EQ(rung.settings.interleave, 1);
}

TEST(Quality, WithInterleavingThereIsNoSupersampling)
{
    for (const Rung& rung : rungs_of(dear(), true))
        EXPECT_FALSE(rung.settings.interleave > 1 &&
                     (rung.settings.adaptive > 1 || rung.settings.samples > 1));
}

/// Plays frames that take what `cost` says, and gives the rung at the end.
template <class Cost>
int settled(QualityLadder& ladder, int frames, const Cost& cost, QualityLadder::Time& now)
{
    for (int k = 0; k < frames; ++k) {
        const int rung = ladder.rung(5);
        now += std::chrono::milliseconds(int(cost(rung)));
        ladder.made(rung, cost(rung), 16, 5, now);
    }
    return ladder.rung(5);
}

TEST(QualityLadder, FindsTheFirstRungThatHoldsTheRate)
{
    QualityLadder ladder;
    QualityLadder::Time now{};
    now += std::chrono::hours(1);
    const auto cost = [](int rung) { return 80.0 / (1 << rung); }; // 80 40 20 10 5
    EXPECT_EQ(settled(ladder, 40, cost, now), 3);
}

TEST(QualityLadder, ComesBackWhenTheLoadIsGone)
{
    QualityLadder ladder;
    QualityLadder::Time now{};
    now += std::chrono::hours(1);
    (void)settled(
        ladder, 40, [](int) { return 100.0; }, now);
    EXPECT_EQ(ladder.rung(5), 4);
    EXPECT_EQ(settled(
                  ladder, 2000, [](int) { return 4.0; }, now),
        0);
}

TEST(QualityLadder, StaysWithinTheRungsThereAre)
{
    QualityLadder ladder;
    QualityLadder::Time now{};
    now += std::chrono::hours(1);
    (void)settled(
        ladder, 40, [](int) { return 100.0; }, now);
    EXPECT_EQ(ladder.rung(2), 1);
}

} // namespace
} // namespace firsthit::cli::view
