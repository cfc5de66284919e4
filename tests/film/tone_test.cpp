// tone_test.cpp - exposure and tone mapping, against their formulas in double.
#include "message_of.h"

#include <firsthit/error.h>
#include <firsthit/film.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace firsthit {
namespace {

using Color = std::array<double, 3>;

constexpr Color kColors[] = {{0, 0, 0}, {0.01, 0.02, 0.005}, {0.05, 0.3, 0.7}, {0.5, 0.5, 0.5},
    {1, 1, 1}, {4, 0.2, 0.1}, {0.3, 9, 30}, {500, 400, 300}};

std::vector<float> shown(const Color& color, const Tone& tone)
{
    return toned({float(color[0]), float(color[1]), float(color[2])}, tone);
}

TEST(Tone, NoneLeavesColoursAndExposureMultipliesThem)
{
    for (const Color& color : kColors) {
        const std::vector<float> same = shown(color, {}), twice = shown(color, {.exposure_ev = 1}),
                                 half = shown(color, {.exposure_ev = -1});
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_EQ(same[c], float(color[c]));
            EXPECT_EQ(twice[c], 2 * float(color[c]));
            EXPECT_EQ(half[c], 0.5f * float(color[c]));
        }
    }
}

/// By the specification's text, in double.
Color neutral(Color color)
{
    const double x = *std::min_element(color.begin(), color.end());
    const double offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
    for (double& c : color) c -= offset;
    const double p = *std::max_element(color.begin(), color.end());
    if (p <= 0.76) return color;
    const double n = 1 - 0.24 * 0.24 / (p + 0.24 - 0.76);
    const double g = 1 / (0.15 * (p - n) + 1);
    for (double& c : color) c = n * (1 - g) + c * n / p * g;
    return color;
}

TEST(Tone, KhronosPbrNeutralIsItsSpecification)
{
    for (const Color& color : kColors) {
        const Color expected = neutral(color);
        const std::vector<float> found = shown(color, {.map = ToneMap::khronos_pbr_neutral});
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(found[c], expected[c], 2e-6 + 2e-6 * expected[c]);
            EXPECT_LT(found[c], 1);
        }
    }
}

TEST(Tone, AcesIsTheFitOfItsSource)
{
    const double in[3][3] = {
        {0.59719, 0.35458, 0.04823}, {0.07600, 0.90834, 0.01566}, {0.02840, 0.13383, 0.83777}};
    const double out[3][3] = {{1.60475, -0.53108, -0.07367}, {-0.10208, 1.10813, -0.00605},
        {-0.00327, -0.07276, 1.07602}};
    for (const Color& color : kColors) {
        Color fitted{};
        for (int row = 0; row < 3; ++row) {
            double v = 0;
            for (int k = 0; k < 3; ++k) v += in[row][k] * color[std::size_t(k)];
            fitted[std::size_t(row)] =
                (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
        }
        const std::vector<float> found = shown(color, {.map = ToneMap::aces});
        for (int row = 0; row < 3; ++row) {
            double expected = 0;
            for (int k = 0; k < 3; ++k) expected += out[row][k] * fitted[std::size_t(k)];
            EXPECT_NEAR(found[std::size_t(row)], std::clamp(expected, 0.0, 1.0), 1e-5);
        }
    }
}

TEST(Tone, MapsWhatIsNoLightToNone)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinite = std::numeric_limits<float>::infinity();
    for (const ToneMap map : {ToneMap::aces, ToneMap::khronos_pbr_neutral})
        for (const float value : toned({nan, -3, infinite, 1e38f, 1e38f, 1e38f}, {.map = map})) {
            EXPECT_GE(value, 0);
            EXPECT_LE(value, 1);
        }
}

TEST(Tone, RefusesAnExposureOutOfRange)
{
    EXPECT_NE(message_of<ArgumentError>([] { (void)toned({}, {.exposure_ev = 101}); }).find("101"),
        std::string::npos);
}

} // namespace
} // namespace firsthit
