// fill_holes_test.cpp - holes take the colours around them.
#include "film/fill_holes.h"
#include "instruction_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace firsthit {
namespace {

struct HoledPicture {
    int width, height;
    std::vector<std::uint8_t> hole;
    std::vector<float> color;

    HoledPicture(int w, int h)
        : width(w),
          height(h),
          hole(std::size_t(w * h)),
          color(std::size_t(w * h) * 3)
    {
        for (std::size_t k = 0; k < color.size(); ++k) color[k] = float(k % 97) / 97;
    }

    std::size_t at(int x, int y) const { return std::size_t(y * width + x); }
    float& red(int x, int y) { return color[at(x, y) * 3]; }
    void mark(int x, int y) { hole[at(x, y)] = 1; }
    std::uint64_t fill() { return fill_holes({width, height, hole, color}, 0, height); }
};

TEST(FillHoles, AHoleIsTheMeanOfItsNeighboursByTheirDistance)
{
    HoledPicture picture(5, 5);
    picture.mark(2, 2);
    const auto at = [&](int x, int y) { return picture.red(x, y); };
    const float expected = (at(2, 1) + at(1, 2) + at(3, 2) + at(2, 3) +
                               (at(1, 1) + at(3, 1) + at(1, 3) + at(3, 3)) / 2) /
                           6;
    EXPECT_EQ(picture.fill(), 1u);
    EXPECT_NEAR(at(2, 2), expected, 1e-6f);
}

TEST(FillHoles, OtherPixelsKeepTheirColours)
{
    HoledPicture picture(40, 30);
    std::mt19937 random(3);
    for (std::uint8_t& hole : picture.hole) hole = random() % 3 == 0;
    const std::vector<float> before = picture.color;
    picture.fill();
    for (std::size_t k = 0; k < picture.color.size(); ++k)
        EXPECT_TRUE(picture.hole[k / 3] || picture.color[k] == before[k]) << k;
}

TEST(FillHoles, TheSmallestWindowWithAPixelCounts)
{
    HoledPicture picture(7, 7);
    std::fill(picture.hole.begin(), picture.hole.end(), std::uint8_t(1));
    picture.hole[picture.at(0, 3)] = 0; // 2 from (2, 3), 3 from (3, 3)
    picture.hole[picture.at(3, 0)] = 0; // 3 from both
    picture.red(0, 3) = 1;
    picture.red(3, 0) = 0;
    EXPECT_EQ(picture.fill(), 47u);
    EXPECT_EQ(picture.red(2, 3), 1);
    EXPECT_EQ(picture.red(3, 3), 0.5f);
}

TEST(FillHoles, WorksInEveryCornerOfAnySize)
{
    for (const auto& [width, height] : {std::pair(1, 9), {9, 1}, {2, 2}, {3, 17}}) {
        for (int k = 0; k < width * height; ++k) {
            HoledPicture picture(width, height);
            std::fill(picture.color.begin(), picture.color.end(), 0.25f);
            picture.mark(k % width, k / width);
            picture.red(k % width, k / width) = 9;
            EXPECT_EQ(picture.fill(), 1u);
            EXPECT_EQ(picture.red(k % width, k / width), 0.25f);
        }
    }
}

TEST(FillHoles, APictureOfHolesStaysAsItIs)
{
    HoledPicture picture(50, 40);
    std::fill(picture.hole.begin(), picture.hole.end(), std::uint8_t(1));
    const std::vector<float> before = picture.color;
    EXPECT_EQ(picture.fill(), 0u);
    EXPECT_EQ(picture.color, before);
}

TEST(FillHoles, RowsMayBeFilledInAnyOrder)
{
    HoledPicture picture(40, 30);
    std::mt19937 random(4);
    for (std::uint8_t& hole : picture.hole) hole = random() % 4 != 0;
    HoledPicture upwards = picture, ranges = picture;
    picture.fill();
    for (int y = 29; y >= 0; --y)
        fill_holes({upwards.width, upwards.height, upwards.hole, upwards.color}, y, y + 1);
    EXPECT_EQ(upwards.color, picture.color);
    for (const int y : {20, 0, 10})
        fill_holes({ranges.width, ranges.height, ranges.hole, ranges.color}, y, y + 10);
    EXPECT_EQ(ranges.color, picture.color);
}

TEST(FillHoles, HasTheSameBitsOnEveryInstructionSet)
{
    for (const unsigned one_in : {2u, 5u, 60u}) {
        HoledPicture holes(71, 30);
        std::mt19937 random(5);
        for (std::uint8_t& hole : holes.hole) hole = random() % one_in != 0;
        HoledPicture expected = holes;
        const std::uint64_t count = expected.fill();
        for_instruction_sets([&] {
            HoledPicture ours = holes;
            EXPECT_EQ(ours.fill(), count);
            EXPECT_EQ(ours.color, expected.color);
        });
    }
}

TEST(FillHoles, NothingComesFromAHolesColour)
{
    HoledPicture picture(50, 20);
    std::mt19937 random(6);
    std::fill(picture.color.begin(), picture.color.end(), 0.5f);
    for (std::size_t k = 0; k < picture.hole.size(); ++k) {
        if (random() % 3 == 0) continue;
        picture.hole[k] = 1;
        for (std::size_t c = 0; c < 3; ++c)
            picture.color[3 * k + c] = std::numeric_limits<float>::quiet_NaN();
    }
    picture.fill();
    for (const float value : picture.color) EXPECT_NEAR(value, 0.5f, 1e-6f);
}

} // namespace
} // namespace firsthit
