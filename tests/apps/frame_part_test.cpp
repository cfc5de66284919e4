// frame_part_test.cpp - parts of the frames of a run: --only and --chunk.
#include "common/usage.h"
#include "inputs/frame_part.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace firsthit::cli {
namespace {

std::vector<int> numbers_to(int count, int first = 0)
{
    std::vector<int> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), first);
    return numbers;
}

TEST(FramePart, ChunksHaveEachFrameOnceInRunsOfEqualLength)
{
    for (const int frames : {0, 1, 2, 7, 100, 601})
        for (const int chunks : {1, 2, 3, 7, 64, 1000}) {
            const std::vector<int> numbers = numbers_to(frames, 5);
            std::vector<int> seen(numbers.size(), 0);
            std::ptrdiff_t least = frames, most = 0;
            std::size_t next = 0;
            for (int k = 1; k <= chunks; ++k) {
                const std::vector<bool> part =
                    frames_in_part({.only = {}, .chunk = Chunk{k, chunks}}, numbers);
                ASSERT_EQ(part.size(), numbers.size());
                const std::ptrdiff_t size = std::count(part.begin(), part.end(), true);
                least = std::min(least, size);
                most = std::max(most, size);
                for (std::size_t frame = 0; frame < part.size(); ++frame)
                    if (part[frame]) {
                        EXPECT_EQ(frame, next++) << "in order, without a gap";
                        ++seen[frame];
                    }
            }
            EXPECT_TRUE(std::ranges::all_of(seen, [](int times) { return times == 1; }));
            EXPECT_LE(most - least, 1) << frames << " frames, " << chunks << " chunks";
        }
}

TEST(FramePart, OnlyKeepsNumbersAndChunksDivideWhatIsLeft)
{
    const std::vector<int> numbers = numbers_to(10, 40); // 40 to 49
    EXPECT_EQ(frames_in_part({.only = {3, 41, 43, 48, 70}, .chunk = {}}, numbers),
        (std::vector<bool>{0, 1, 0, 1, 0, 0, 0, 0, 1, 0}));
    EXPECT_EQ(frames_in_part({.only = {41, 43, 48}, .chunk = Chunk{2, 3}}, numbers),
        (std::vector<bool>{0, 0, 0, 1, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(frames_in_part({.only = {1, 2}, .chunk = {}}, numbers), std::vector<bool>(10, false));
    EXPECT_EQ(frames_in_part({}, numbers), std::vector<bool>(10, true));
    EXPECT_FALSE(FramePart().any());
}

TEST(FramePart, ReadsChunks)
{
    const Chunk chunk = parse_chunk("3/10");
    EXPECT_EQ(chunk.number, 3);
    EXPECT_EQ(chunk.count, 10);
    EXPECT_EQ(parse_chunk("1000000/1000000").number, 1000000);
    for (const char* text : {"", "3", "/", "3/", "/3", "0/3", "4/3", "-1/3", "1/0", "1/1000001",
             "1.5/3", "1/3/5", "a/b", "1 /3"})
        EXPECT_THROW(parse_chunk(text), UsageError) << text;
}

} // namespace
} // namespace firsthit::cli
