// quartiles_test.cpp - medians and quartiles, and measuring in turn.
#include "bench/measure/in_turn.h"
#include "bench/measure/quartiles.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace firsthit::cli::bench {
namespace {

TEST(Quartiles, OfFiveValuesAreTheSecondThirdAndFourth)
{
    const Quartiles q = quartiles({50, 10, 40, 20, 30});
    EXPECT_EQ(q.lower, 20);
    EXPECT_EQ(q.median, 30);
    EXPECT_EQ(q.upper, 40);
    EXPECT_EQ(q.count, 5u);
}

TEST(Quartiles, BetweenTwoValuesAreInterpolated)
{
    const Quartiles q = quartiles({4, 1, 3, 2});
    EXPECT_EQ(q.lower, 1.75);
    EXPECT_EQ(q.median, 2.5);
    EXPECT_EQ(q.upper, 3.25);
}

TEST(Quartiles, OfOneValueAreThatValue)
{
    const Quartiles q = quartiles({7});
    EXPECT_EQ(q.lower, 7);
    EXPECT_EQ(q.median, 7);
    EXPECT_EQ(q.upper, 7);
}

TEST(Quartiles, OfNothingCountNothing)
{
    EXPECT_EQ(quartiles({}).count, 0u);
}

TEST(Quartiles, PerSecondTurnsTheOrderRound)
{
    const Quartiles fps = per_second({.lower = 10, .median = 20, .upper = 50, .count = 3});
    EXPECT_EQ(fps.lower, 20);
    EXPECT_EQ(fps.median, 50);
    EXPECT_EQ(fps.upper, 100);
    EXPECT_EQ(fps.count, 3u);
}

/// Notes who is asked for which round.
Contender noted(std::string name, std::string& calls)
{
    return {name, [name, &calls](int round) {
                calls += name + std::to_string(round) + " ";
                return double(round);
            }};
}

TEST(InTurn, EveryRoundAsksAllAndBeginsWithAnother)
{
    std::string calls;
    measure_in_turn({noted("a", calls), noted("b", calls)}, 2, 1);
    EXPECT_EQ(calls, "a-1 b-1 b0 a0 a1 b1 ");
}

TEST(InTurn, WhatWarmsUpIsNotKept)
{
    std::string calls;
    const std::vector<Times> times = measure_in_turn({noted("a", calls)}, 3, 2);
    EXPECT_EQ(times[0].ms, (std::vector<double>{0, 1, 2}));
}

TEST(InTurn, WhoLacksADeviceIsLeftOutAndSaysWhy)
{
    int asked = 0;
    std::string calls;
    const Contender broken = {"gpu", [&](int) -> double {
                                  ++asked;
                                  throw DeviceError("no OpenGL here");
                              }};
    const std::vector<Times> times = measure_in_turn({broken, noted("a", calls)}, 3, 1);
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(times[0].failure, "no OpenGL here");
    EXPECT_TRUE(times[0].ms.empty());
    EXPECT_EQ(times[1].ms.size(), 3u);
}

TEST(InTurn, OtherErrorsPass)
{
    const Contender broken = {"a", [](int) -> double { throw std::logic_error("wrong"); }};
    EXPECT_THROW(measure_in_turn({broken}, 1, 0), std::logic_error);
}

TEST(InTurn, TellsOfEveryFrame)
{
    std::string calls;
    int done = 0;
    measure_in_turn({noted("a", calls), noted("b", calls)}, 3, 1, [&] { ++done; });
    EXPECT_EQ(done, 8);
}

} // namespace
} // namespace firsthit::cli::bench
