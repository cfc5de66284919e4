// srgb_test.cpp - compares the tables with the formulas.
#include "base/srgb.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <vector>

namespace firsthit {
namespace {

std::vector<std::uint8_t> convert(const std::vector<float>& linear)
{
    std::vector<std::uint8_t> code(linear.size());
    srgb_table().codes(linear, code);
    return code;
}

void expect_the_formula(const std::vector<float>& linear)
{
    const std::vector<std::uint8_t> code = convert(linear);
    for (std::size_t k = 0; k < linear.size(); ++k)
        ASSERT_EQ(int(code[k]), int(srgb_from_linear(linear[k]))) << "at " << linear[k];
}

TEST(Srgb, TheTableIsTheFormulaOverTheFloatsFromZeroToOne)
{
    std::vector<float> linear;
    for (std::uint32_t bits = 0; bits <= 0x3F800000; bits += 499)
        linear.push_back(std::bit_cast<float>(bits));
    expect_the_formula(linear);
}

TEST(Srgb, TheTableIsTheFormulaOnBothSidesOfEveryThreshold)
{
    std::vector<float> linear;
    std::uint32_t low = 0;
    for (int code = 1; code < 256; ++code) {
        std::uint32_t high = 0x3F800000;
        while (high - low > 1) {
            const std::uint32_t middle = (low + high) / 2;
            (srgb_from_linear(std::bit_cast<float>(middle)) >= code ? high : low) = middle;
        }
        for (std::uint32_t bits = high - 3; bits <= high + 3; ++bits)
            linear.push_back(std::bit_cast<float>(bits));
    }
    expect_the_formula(linear);
}

TEST(Srgb, WhatIsOutsideZeroToOneIsClampedAndNoNumberIsBlack)
{
    const float inf = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<std::uint8_t> expected = {0, 0, 0, 255, 255, 255, 0, 0};
    EXPECT_EQ(convert({-inf, -1.0f, -0.0f, 1.0f, 1.5f, inf, nan, -nan}), expected);
}

TEST(Srgb, OneValueIsConvertedLikeMany)
{
    for (const float linear : {-1.0f, 0.0f, 1e-4f, 0.2f, 0.999f, 1.0f, 2.0f})
        EXPECT_EQ(srgb_table().code(linear), convert({linear})[0]) << linear;
}

TEST(Srgb, EveryCodeComesBackFromItsLinearValue)
{
    for (std::size_t code = 0; code < 256; ++code)
        EXPECT_EQ(srgb_table().code(linear_from_srgb()[code]), code);
}

TEST(Srgb, LinearValuesAreThoseOfTheStandard)
{
    EXPECT_EQ(linear_from_srgb()[0], 0.0f);
    EXPECT_EQ(linear_from_srgb()[255], 1.0f);
    EXPECT_FLOAT_EQ(linear_from_srgb()[10], 10 / 255.0f / 12.92f) << "the straight part";
    EXPECT_NEAR(linear_from_srgb()[188], 0.5029f, 1e-4f) << "half the light";
}

TEST(Srgb, DisplayedValuesAreThoseOfTheStandard)
{
    EXPECT_DOUBLE_EQ(srgb_value(0.002f), 12.92 * double(0.002f)) << "the straight part";
    EXPECT_NEAR(srgb_value(0.5f), 0.735357, 1e-6);
    EXPECT_EQ(srgb_value(7), 1);
    EXPECT_EQ(srgb_value(-1), 0);
    EXPECT_EQ(srgb_value(std::numeric_limits<float>::quiet_NaN()), 0);
}

} // namespace
} // namespace firsthit
