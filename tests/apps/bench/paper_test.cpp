// paper_test.cpp - `firsthit bench --paper` tried with few small frames.
#include "bench/paper/figures.h"
#include "bench/paper/numbers.h"
#include "bench/paper/paper.h"
#include "bench/report/machine.h"
#include "temporary_folder.h"

#include <firsthit/error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace firsthit::cli::bench {
namespace {

/// A run of scenes that are always there.
Report quick_report()
{
    BenchOptions options;
    options.paper = true;
    options.quick = true;
    options.size = Size{64, 48};
    options.scenes = "/no & such/<folder>";
    Report made;
    add_paper(options, made);
    return made;
}

void expect_sound(const Json& fps)
{
    EXPECT_GT(fps["lower"].get<double>(), 0);
    EXPECT_LE(fps["lower"].get<double>(), fps["median"].get<double>());
    EXPECT_LE(fps["median"].get<double>(), fps["upper"].get<double>());
    EXPECT_TRUE(std::isfinite(fps["upper"].get<double>()));
    EXPECT_EQ(fps["count"], 2);
}

TEST(Paper, AQuickRunHasANumberOrAReasonEverywhere)
{
    const Json json = quick_report().json["paper"];
    for (const PaperTable& table : kTables) {
        const Json& rows = json["table" + std::to_string(table.number)];
        ASSERT_EQ(rows.size(), table.rows.size());
        for (const Json& row : rows)
            for (const Json& cell : row["scenes"]) {
                const bool cpu = row["way"].get<std::string>().starts_with("cpu");
                if (cell.contains("fps"))
                    expect_sound(cell["fps"]);
                else
                    EXPECT_FALSE(cell["unavailable"].get<std::string>().empty()) << row["row"];
                // The bunny is missing; the cpu engine never is.
                EXPECT_TRUE(cell.contains("fps") || !cpu || cell["scene"] == "Bunny") << row["row"];
            }
    }
    std::size_t points = 0;
    for (const Json& curve : json["figure9"]["curves"])
        for (const Json& fps : curve.value("fps", Json::array())) {
            EXPECT_GT(fps.get<double>(), 0);
            EXPECT_TRUE(std::isfinite(fps.get<double>()));
            ++points;
        }
    EXPECT_GE(points, 12u); // three ways of the cpu engine
    for (const char* const name : {"table1", "figure4", "figure8", "figure10"})
        EXPECT_TRUE(json.contains(name)) << name;
}

TEST(Paper, ThePageShowsEveryTableAndFigure)
{
    const std::string page = to_text(quick_report().page.json());
    for (const char* const part : {"Table 1", "Table 2", "Table 3", "Table 4", "Figure 2",
             "Figure 4", "Figure 7", "Figure 8", "Figure 9", "Figure 10"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
}

TEST(Paper, AMissingBunnyIsNoError)
{
    BenchOptions options;
    options.scenes = "/no & such";
    const std::vector<PaperScene> scenes = paper_scenes(options);
    ASSERT_EQ(scenes.size(), 3u);
    EXPECT_TRUE(scenes[0].scene);
    EXPECT_FALSE(scenes[1].scene);
    EXPECT_EQ(
        scenes[1].note, "/no & such/bunny.stl is missing: scripts/fetch_scenes.sh fetches it");
    EXPECT_TRUE(scenes[2].scene);
}

TEST(Paper, ABartThatIsNoSceneIsAnError)
{
    const TemporaryFolder folder;
    BenchOptions options;
    options.bart = folder.write("Robot.aff", "this is no scene").string();
    EXPECT_THROW(paper_scenes(options), FileError);
}

TEST(Paper, OneLightIsOn)
{
    EXPECT_EQ(paper_scenes({})[0].scene->lights.size(), 1u);
}

TEST(Paper, FramesAreTheMiddlesOfPartsOfTheAnimation)
{
    Scene scene;
    scene.clips.push_back({.begin_s = 10, .end_s = 18});
    EXPECT_EQ(frame_time(scene, 0, 4), 11);
    EXPECT_EQ(frame_time(scene, 3, 4), 17);
}

TEST(Paper, EveryRowNamesAWayThatThereIs)
{
    for (const PaperTable& table : kTables)
        for (const PaperRow& row : table.rows) EXPECT_NO_THROW(paper_way(row.way)) << row.name;
    for (const PaperRatio& ratio : kRatios) {
        EXPECT_NO_THROW(paper_way(ratio.way)) << ratio.name;
        EXPECT_NO_THROW(paper_way(ratio.slower)) << ratio.name;
    }
    EXPECT_THROW(paper_way("abacus"), ArgumentError);
}

/// Frames that were not measured but made up.
PaperMeasured made_up(const std::string& failure)
{
    PaperMeasured measured{.scenes = {}, .ways = paper_ways(), .frames = {}};
    measured.scenes.push_back({.file = "builtin:torus",
        .scene = std::make_shared<const Scene>(load_scene("builtin:torus")),
        .note = "",
        .camera = {}});
    for (const char* const name : {"bunny.stl", "torus.ply"})
        measured.scenes.push_back({.file = name, .scene = {}, .note = "gone", .camera = {}});
    measured.frames.resize(3);
    for (const Way& way : measured.ways) {
        Frames frames;
        if (way.settings.engine == Engine::cpu) {
            frames.ms = {20, 10, 40};
            frames.stats.resize(3);
            for (Stats& stats : frames.stats)
                stats.setup_ms = 1, stats.raster_ms = 4, stats.shade_ms = 5;
        } else
            frames.failure = failure;
        measured.frames[0].push_back(frames);
    }
    return measured;
}

TEST(Paper, WithoutOpenGlTheCellsSayWhy)
{
    Report report;
    Json json;
    add_paper_tables(made_up("no EGL: <none>"), report, json);
    EXPECT_EQ(json["table3"][0]["scenes"][0]["unavailable"], "no EGL: <none>");
    EXPECT_EQ(json["table3"][1]["scenes"][0]["fps"]["median"], 50);
    EXPECT_EQ(json["table3"][1]["scenes"][0]["paper_fps"], 3.2);
    EXPECT_EQ(json["table3"][1]["scenes"][1]["unavailable"], "gone");
    EXPECT_EQ(json["table1"][1]["unavailable"], "gone");
    EXPECT_EQ(json["table2"][3]["scenes"][0]["fps"]["median"], 200); // 1 + 4 ms: items alone
    EXPECT_NE(to_text(report.page.json()).find("no EGL: <none>"), std::string::npos);
}

TEST(Paper, RatiosAreOfFramesOfTheSameRound)
{
    PaperMeasured measured = made_up("no EGL");
    for (std::size_t k = 0; k < measured.ways.size(); ++k)
        if (measured.ways[k].name == "gpu")
            measured.frames[0][k] = {.ms = {60, 40, 80}, .stats = {}, .failure = {}};
    Report report;
    Json json;
    add_paper_tables(measured, report, json);
    const Json& times = json["ratios"][0]["scenes"][0]["times"]; // 60 / 20, 40 / 10, 80 / 40
    EXPECT_EQ(times["median"], 3);
    EXPECT_EQ(times["upper"], 3.5);
    EXPECT_EQ(json["ratios"][1]["scenes"][0]["unavailable"], "no EGL");
    EXPECT_EQ(json["ratios"][0]["scenes"][1]["unavailable"], "gone");
}

TEST(Paper, WhatStagesLeaveOfTheFrameIsTheRest)
{
    Report report;
    Json json;
    add_time_shares(made_up("no EGL"), report, json);
    const Json& bars = json["figure8"]["bars"];
    const auto cpu =
        std::find_if(bars.begin(), bars.end(), [](const Json& bar) { return bar["way"] == "cpu"; });
    ASSERT_NE(cpu, bars.end());
    EXPECT_EQ((*cpu)["percent"]["item buffer"], 25);
    EXPECT_EQ((*cpu)["percent"]["shading"], 25);
    EXPECT_EQ((*cpu)["percent"]["waiting and the rest"], 50);
}

TEST(Machine, IsDescribed)
{
    const Json json = machine_json(describe_machine());
    for (const char* const name : {"cpu", "system", "instruction_set", "date", "firsthit", "commit",
             "compiler", "build_type", "embree", "opengl"})
        EXPECT_FALSE(json[name].get<std::string>().empty()) << name;
    EXPECT_GT(json["cores"].get<int>(), 0);
    EXPECT_GT(json["memory_bytes"].get<double>(), 1e6);
}

} // namespace
} // namespace firsthit::cli::bench
