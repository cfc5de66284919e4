// reports_test.cpp - tables and JSON, and the line of the progress bar.
#include "compare_command.h"
#include "engine_report.h"
#include "info_command.h"
#include "common/progress.h"
#include "scene/model/borrow.h"
#include "stats_report.h"

#include <gtest/gtest.h>

namespace firsthit::cli {
namespace {

RunReport two_frames()
{
    RunReport report;
    report.scene = "builtin:torus";
    report.width = 64;
    report.height = 48;
    report.samples = 2;
    report.frames.resize(2);
    report.frames[1].time_s = 1.5;
    report.frames[0].stats.raster_ms = 1;
    report.frames[1].stats.raster_ms = 3;
    report.frames[1].stats.exact_calls = 7;
    return report;
}

TEST(StatsReport, TheTableHasAllStagesAndCountsThatAreNotZero)
{
    RunReport report = two_frames();
    const char* words[] = {"pose", "setup", "resolve", "shade", "write", "triangles",
        "tile entries", "uncertain lanes", "shadow ", "shadow points", "shadow triangles",
        "shadow pairs", "shadow uncertain", "mark", "fine", "fine pixels", "map updates"};
    const std::string zeros = stats_table(report);
    for (const char* word : words) EXPECT_EQ(zeros.find(word), std::string::npos) << word;
    for (const char* word : {"raster", "exact calls", "peak memory", "load"})
        EXPECT_NE(zeros.find(word), std::string::npos) << word;
    Stats& stats = report.frames[1].stats;
    for (double* ms : {&stats.pose_ms, &stats.setup_ms, &stats.resolve_ms, &stats.shade_ms,
             &stats.write_ms, &stats.shadow_ms, &stats.mark_ms, &stats.fine_ms})
        *ms = 0.02;
    for (std::uint64_t* count : {&stats.triangles, &stats.tile_entries, &stats.uncertain_lanes,
             &stats.shadow_points, &stats.shadow_triangles, &stats.shadow_pairs,
             &stats.shadow_uncertain, &stats.fine_pixels, &stats.map_updates})
        *count = 1;
    const std::string table = stats_table(report);
    for (const char* word : words) EXPECT_NE(table.find(word), std::string::npos) << word;
}

TEST(StatsReport, SeveralFramesHaveAMeanAndALargest)
{
    EXPECT_NE(stats_table(two_frames()).find("raster                  2.00        3.00\n"),
        std::string::npos)
        << stats_table(two_frames());
}

TEST(StatsReport, TheJsonHasEveryFrame)
{
    const Json json = stats_json(two_frames());
    ASSERT_EQ(json["frames"].size(), 2u);
    EXPECT_EQ(json["frames"][1]["time_s"], 1.5);
    EXPECT_EQ(json["frames"][1]["raster_ms"], 3.0);
    EXPECT_EQ(json["frames"][1]["exact_calls"], 7);
    EXPECT_EQ(json["width"], 64);
}

TEST(StatsReport, WhatIsMissedAndInterpolatedIsReported)
{
    RunReport report = two_frames();
    report.frames[0].stats.missed = 12345;
    report.frames[0].stats.interpolated = 67890;
    const Json frame = stats_json(report)["frames"][0];
    EXPECT_EQ(frame["missed"], 12345);
    EXPECT_EQ(frame["interpolated"], 67890);
    const std::string table = stats_table(report);
    EXPECT_NE(table.find("12345"), std::string::npos) << table;
    EXPECT_NE(table.find("67890"), std::string::npos) << table;
}

TEST(StatsReport, TheJsonHasTheCountsOfShadows)
{
    RunReport report = two_frames();
    Stats& stats = report.frames[0].stats;
    stats.shadow_ms = 2.5;
    stats.shadow_points = 1;
    stats.shadow_triangles = 2;
    stats.shadow_pairs = 3;
    stats.shadow_uncertain = 4;
    stats.map_updates = 5;
    const Json frame = stats_json(report)["frames"][0];
    EXPECT_EQ(frame["shadow_ms"], 2.5);
    EXPECT_EQ(frame["shadow_points"], 1);
    EXPECT_EQ(frame["shadow_triangles"], 2);
    EXPECT_EQ(frame["shadow_pairs"], 3);
    EXPECT_EQ(frame["shadow_uncertain"], 4);
    EXPECT_EQ(frame["map_updates"], 5);
}

TEST(InfoReport, CountsLightsByKind)
{
    Scene scene = load_scene("builtin:torus");
    scene.lights.resize(4);
    scene.lights[1].kind = Light::Kind::spot;
    scene.lights[3].kind = Light::Kind::spot;
    World world;
    pose(borrow(scene), 0, world);
    const Json info = describe(scene, world, "torus");
    EXPECT_EQ(info["lights"].size(), 4u);
    EXPECT_EQ(info["light_kinds"].dump(), R"({"point":2,"spot":2,"directional":0})");
    EXPECT_NE(info_text(info).find("lights     4: 2 point, 2 spot\n"), std::string::npos)
        << info_text(info);
}

TEST(StatsReport, ANameThatIsNoUtf8IsStillJson)
{
    RunReport report = two_frames();
    report.scene = "\xFF\".ply";
    const Json back = Json::parse(to_text(stats_json(report)));
    EXPECT_EQ(back["scene"], "\xEF\xBF\xBD\".ply");
}

TEST(CompareReport, TheJsonHasTheFiveCountsInOrder)
{
    const Comparison comparison{
        .pixels = 10, .agree = 6, .ties = 3, .ours_wrong = 0, .theirs_wrong = 1};
    EXPECT_EQ(comparison_json(comparison, {}).dump(),
        R"({"pixels":10,"agree":6,"ties":3,"ours_wrong":0,"theirs_wrong":1})");
}

TEST(CompareReport, LitCountsAreThereWhereShadowsWereCompared)
{
    const LitComparison lit{.pixels = 10, .agree = 7, .ours_wrong = 2, .theirs_wrong = 1};
    const LitComparison sum = lit + lit;
    const Json json = comparison_json({}, sum);
    EXPECT_EQ(json["lit_pixels"], 20);
    EXPECT_EQ(json["lit_agree"], 14);
    EXPECT_EQ(json["lit_ours_wrong"], 4);
    EXPECT_EQ(json["lit_theirs_wrong"], 2);
    EXPECT_NE(comparison_text({}, lit).find("lit ours wrong              2\n"), std::string::npos);
    EXPECT_EQ(comparison_text({}, {}).find("lit"), std::string::npos);
}

TEST(CompareReport, CountsAreSummed)
{
    const Comparison a{.pixels = 1, .agree = 2, .ties = 3, .ours_wrong = 4, .theirs_wrong = 5};
    const Comparison sum = a + a;
    EXPECT_EQ(sum.pixels, 2u);
    EXPECT_EQ(sum.theirs_wrong, 10u);
}

EngineComparison hybrid_comparison()
{
    EngineComparison comparison;
    comparison.pixels = 100;
    comparison.missed = 5;
    comparison.wrong = 4;
    comparison.ties = 3;
    comparison.interpolated = 2;
    comparison.square_sum = 0.3;
    comparison.largest_difference = 0.25;
    return comparison;
}

TEST(EngineReport, TheJsonHasEveryNumberInOrder)
{
    EngineComparison comparison = hybrid_comparison();
    comparison.square_sum = 300; // 0 dB
    EXPECT_EQ(engine_comparison_json(comparison, "pipe").dump(),
        R"({"pixels":100,"missed":5,"wrong":4,"ties":3,"interpolated":2,"psnr_db":0.0,)"
        R"("largest_difference":0.25,"device":"pipe"})");
    comparison.square_sum_same_items = 300;
    EXPECT_EQ(engine_comparison_json(comparison, "pipe")["psnr_same_items_db"], 0.0);
}

TEST(EngineReport, EqualPicturesHaveNoDecibels)
{
    EngineComparison comparison = hybrid_comparison();
    comparison.square_sum = 0;
    comparison.square_sum_same_items = 0;
    const Json json = engine_comparison_json(comparison, "pipe");
    EXPECT_TRUE(json["psnr_db"].is_null());
    EXPECT_TRUE(json["psnr_same_items_db"].is_null());
    EXPECT_TRUE(json.contains("psnr_same_items_db"));
}

TEST(EngineReport, TheTableHasSharesAndDecibels)
{
    EngineComparison comparison = hybrid_comparison();
    const std::string table = engine_comparison_text(comparison, "pipe");
    EXPECT_NE(table.find("missed                          5     5.0000 %\n"), std::string::npos)
        << table;
    EXPECT_NE(table.find("30.00 dB"), std::string::npos) << table;
    EXPECT_EQ(table.find("same items"), std::string::npos) << table;
    comparison.square_sum_same_items = 0;
    EXPECT_NE(engine_comparison_text(comparison, "pipe").find("equal"), std::string::npos);
}

TEST(Progress, TheLineFillsUp)
{
    EXPECT_EQ(
        progress_line("frames", 1, 4), "frames [##########------------------------------] 1/4");
    EXPECT_EQ(
        progress_line("frames", 4, 4), "frames [########################################] 4/4");
}

} // namespace
} // namespace firsthit::cli
