// frame_choice_test.cpp - which frames --frames means.
#include "inputs/frame_choice.h"

#include "common/progress.h"
#include "common/usage.h"
#include "masks/coco_rle.h"
#include "options/data_options.h"

#include <gtest/gtest.h>

namespace firsthit::cli {
namespace {

using Numbers = std::vector<int>;
using Times = std::vector<double>;

Scene scene_with_clip(double begin_s, double end_s, int frames)
{
    Scene scene;
    Clip clip;
    clip.begin_s = begin_s;
    clip.end_s = end_s;
    clip.frames = frames;
    scene.clips.push_back(clip);
    return scene;
}

TEST(FrameChoice, IsTimesOrNumbersOrTheClip)
{
    EXPECT_EQ(parse_frame_choice("0:1:3").times, (Times{0, 0.5, 1}));
    EXPECT_EQ(parse_frame_choice("7").numbers, Numbers{7});
    EXPECT_EQ(parse_frame_choice("3-6").numbers, (Numbers{3, 4, 5, 6}));
    EXPECT_EQ(parse_frame_choice("0-10/4").numbers, (Numbers{0, 4, 8}));
    EXPECT_EQ(parse_frame_choice("9,1,2-3,3").numbers, (Numbers{1, 2, 3, 9}));
    EXPECT_TRUE(parse_frame_choice("clip").clip);
    for (const char* text : {"", "-1", "3-", "5-3", "1,", ",1", "1-2/0", "1-2/", "a", "1.5", "1 2",
             "0-1000000", "9999999999", "Clip", "--", "1-2-3", "0-999999,1000000-1999999"})
        EXPECT_THROW(parse_frame_choice(text), UsageError) << text;
    EXPECT_EQ(parse_frame_choice("999999999").numbers, Numbers{999999999});
    EXPECT_EQ(parse_frame_choice("0-999999").numbers.size(), 1000000u);
}

TEST(FrameChoice, NumbersAreTimesByTheFramesASecond)
{
    const Scene scene = scene_with_clip(2, 4, 61);
    const PoseSettings pose{.time_s = 2};
    const Frames few = frames_of(parse_frame_choice("0-20/10"), scene, pose, 10.0);
    EXPECT_EQ(few.time_s, (Times{2, 3, 4}));
    EXPECT_EQ(few.number, (Numbers{0, 10, 20}));
    EXPECT_EQ(few.fps, 10);
    EXPECT_EQ(frames_of(parse_frame_choice("48"), scene, pose, {}).time_s, Times{4}); // 24 a second
}

TEST(FrameChoice, AClipHasTheFramesOfItsFileOrOfTheSpeed)
{
    const PoseSettings pose{.time_s = 2};
    const Frames own = frames_of(parse_frame_choice("clip"), scene_with_clip(2, 4, 61), pose, {});
    EXPECT_EQ(own.size(), 61u);
    EXPECT_EQ(own.fps, 30);
    EXPECT_EQ(own.time_s.front(), 2);
    EXPECT_EQ(own.time_s.back(), 4);
    EXPECT_EQ(own.number.back(), 60);
    const Frames rounded =
        frames_of(parse_frame_choice("clip"), scene_with_clip(0, 0.708, 22), PoseSettings{}, {});
    EXPECT_EQ(rounded.fps, 30); // 21 / 0.708 is 29.7
    EXPECT_EQ(rounded.size(), 22u);
    EXPECT_EQ(rounded.time_s.back(), 0.7);
    const Frames slow = frames_of(parse_frame_choice("clip"), scene_with_clip(0, 1, 2), pose, 2.5);
    EXPECT_EQ(slow.time_s, (Times{0, 0.4, 0.8}));
    EXPECT_EQ(frames_of(parse_frame_choice("clip"), Scene(), pose, {}).size(), 1u);
    EXPECT_THROW(
        frames_of(parse_frame_choice("clip"), scene_with_clip(0, 1e9, 2), pose, 1e6), UsageError);
}

TEST(FrameChoice, TimesAreShownAsFastAsTheyAre)
{
    const Scene scene = scene_with_clip(0, 10, 2);
    EXPECT_EQ(frames_of(parse_frame_choice("0:10:251"), scene, {}, {}).fps, 25);
    EXPECT_EQ(frames_of(parse_frame_choice("0:10:251"), scene, {}, 60.0).fps, 60);
    EXPECT_EQ(frames_of(parse_frame_choice("1:1:3"), scene, {}, {}).fps, 24);
    EXPECT_EQ(frames_of(FrameChoice{}, scene, PoseSettings{.time_s = 3}, {}).time_s, Times{3});
}

TEST(Planes, AreChosenByName)
{
    const auto some = parse_planes("color,depth,normal,depth");
    ASSERT_TRUE(some);
    EXPECT_TRUE(some->color);
    EXPECT_EQ(some->aovs, (std::vector{Aov::depth, Aov::normal}));
    EXPECT_FALSE(parse_planes("depth")->color);
    EXPECT_FALSE(parse_planes("all"));
    for (const char* text : {"", "depth,", "Depth", "rgb"})
        EXPECT_THROW(parse_planes(text), UsageError) << text;
    EXPECT_EQ(all_planes(0, false).aovs.size(), std::size_t(kAovCount) - 3);
    EXPECT_EQ(all_planes(1, true).aovs.size(), std::size_t(kAovCount));
    EXPECT_EQ(all_planes(65, true).aovs.size(), std::size_t(kAovCount) - 1);
}

TEST(ProgressRate, HasTheSpeedAndTheTimeLeft)
{
    EXPECT_EQ(progress_rate(0, 10, 1), "");
    EXPECT_EQ(progress_rate(5, 10, 2), "  2.50 a second, 2 s left");
    EXPECT_EQ(progress_rate(10, 10, 0.5), "  20.0 a second, 0 s left");
    EXPECT_EQ(progress_rate(1, 101, 1), "  1.00 a second, 1:40 min left");
    EXPECT_EQ(progress_rate(1, 7201, 1), "  1.00 a second, 2:00 h left");
    EXPECT_EQ(progress_rate(1, 1000000, 1e6), "  0.00 a second, 277777:46 h left");
}

TEST(CocoRle, HasRunsDownTheColumns)
{
    // Of [[0 1 1], [0 0 1]], by columns 0 0, 1 0, 1 1: counts 2 1 1 2.
    const auto masks = masks_of(std::vector<std::uint32_t>{9, 1, 1, 9, 9, 1}, 3, 9);
    ASSERT_EQ(masks.size(), 1u);
    const MaskShape& mask = masks.at(1);
    EXPECT_EQ(mask.rle.counts, (std::vector<std::uint32_t>{2, 1, 1, 2}));
    EXPECT_EQ(mask.area, 3u);
    EXPECT_EQ(mask.x, 1u);
    EXPECT_EQ(mask.y, 0u);
    EXPECT_EQ(mask.box_width, 2u);
    EXPECT_EQ(mask.box_height, 2u);
    EXPECT_EQ(compressed_counts({1, 1, {0, 1}}), "01");
    // The fourth is less the second: 2 - 1.
    EXPECT_EQ(compressed_counts(mask.rle), "2111");
    // 16: 10000 0; 1000: 01000 11111 0; 31: 11111 0; 8 - 1000: 00000 00001 11111, lowest first.
    EXPECT_EQ(compressed_counts({1, 1, {16, 1000, 31, 8}}), "`0Xo0o0PQO");
}

} // namespace
} // namespace firsthit::cli
