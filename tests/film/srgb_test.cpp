// srgb_test.cpp - the table against the formula.
#include "film/srgb.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace firsthit {
namespace {

std::vector<std::uint8_t> convert(const std::vector<float>& linear)
{
    std::vector<std::uint8_t> code(linear.size());
    SrgbTable().convert(linear, code);
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

TEST(Srgb, EveryCodeComesBackFromItsLinearValue)
{
    for (int code = 0; code < 256; ++code) {
        const double s = code / 255.0;
        const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
        EXPECT_EQ(convert({static_cast<float>(linear)})[0], code);
    }
}

} // namespace
} // namespace firsthit
