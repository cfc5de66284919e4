// power_test.cpp - the functions of src/glsl/power.glsl are as accurate as they state.
#include "base/scalar_real.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace firsthit::scalar {
#include "glsl/power.glsl"

namespace {

TEST(SteadyLog2, IsWithinItsRelativeError)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> exponent(-126, 127), near_one(0.5f, 2.0f);
    for (int k = 0; k < 2000000; ++k) {
        const float x = k % 2 ? std::exp2(exponent(random)) : near_one(random);
        const double expected = std::log2(double(x));
        ASSERT_NEAR(steady_log2(x), expected, 3e-7 * std::abs(expected)) << x;
    }
    EXPECT_EQ(steady_log2(1.0f), 0.0f);
    EXPECT_EQ(steady_log2(8.0f), 3.0f);
}

TEST(SteadyExp2, IsWithinItsRelativeError)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> any(-125.99f, 126.99f), small(-1, 1);
    for (int k = 0; k < 2000000; ++k) {
        const float y = k % 2 ? any(random) : small(random);
        const double expected = std::exp2(double(y));
        ASSERT_NEAR(steady_exp2(y), expected, 3e-7 * expected) << y;
    }
    EXPECT_EQ(steady_exp2(0.0f), 1.0f);
    EXPECT_EQ(steady_exp2(-5.0f), 1.0f / 32);
}

TEST(SteadyPow, IsWithinItsErrors)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> base(0, 1), log_exponent(-7, 20);
    for (int k = 0; k < 2000000; ++k) {
        const float exponent = std::exp2(log_exponent(random));
        // Half of the bases where the power is neither 0 nor 1.
        const float x = k % 2 ? base(random) : std::exp2(-8 * base(random) / exponent);
        if (x < std::numeric_limits<float>::min()) continue;
        const double expected = std::pow(double(x), double(exponent));
        const double error = std::abs(steady_pow(x, exponent) - expected);
        ASSERT_LE(error, 1e-6) << x << "^" << exponent;
        if (expected > 1e-6) {
            ASSERT_LE(error, 3e-6 * expected) << x << "^" << exponent;
        }
    }
}

TEST(SteadyPow, IsZeroAtZeroAndOneAtOne)
{
    for (const float exponent : {1e-3f, 0.5f, 1.0f, 77.0f, 1e30f}) {
        EXPECT_EQ(steady_pow(0.0f, exponent), 0.0f);
        EXPECT_EQ(steady_pow(1.0f, exponent), 1.0f);
    }
}

TEST(SteadyPowWhole, IsRepeatedMultiplication)
{
    EXPECT_EQ(steady_pow_whole(0.0f, 0), 1.0f);
    EXPECT_EQ(steady_pow_whole(0.5f, 10), 1.0f / 1024);
    for (int exponent = 0; exponent <= 64; ++exponent)
        for (float x = 0; x <= 1; x += 0.01f) {
            const double expected = std::pow(double(x), exponent);
            EXPECT_NEAR(steady_pow_whole(x, exponent), expected, 4e-6 * expected + 1e-38);
        }
}

} // namespace
} // namespace firsthit::scalar
