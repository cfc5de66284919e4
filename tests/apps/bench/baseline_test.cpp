// baseline_test.cpp - `firsthit bench --baseline` tried with few small frames.
#include "bench/baseline/baseline.h"
#include "bench/baseline/frame_maker.h"
#include "bench/baseline/frames.h"
#include "bench/baseline/moving_scenes.h"
#include "bench/baseline/picture_difference.h"
#include "bench/baseline/scenes.h"
#include "bench/baseline/tables.h"

#include <firsthit/error.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace firsthit::cli::bench {
namespace {

bool has_embree()
{
    return !baseline_version().empty();
}

const Report& quick_baseline()
{
    static const Report report = [] {
        BenchOptions options;
        options.baseline = true;
        options.quick = true;
        options.size = Size{64, 48};
        options.scenes = "/no & such/<folder>";
        Report made;
        add_baseline(options, made);
        return made;
    }();
    return report;
}

void expect_sound_baseline(const Json& values)
{
    EXPECT_GT(values["lower"].get<double>(), 0);
    EXPECT_LE(values["lower"].get<double>(), values["median"].get<double>());
    EXPECT_LE(values["median"].get<double>(), values["upper"].get<double>());
    EXPECT_TRUE(std::isfinite(values["upper"].get<double>()));
    EXPECT_EQ(values["count"], 2);
}

TEST(Baselines, AQuickRunHasTimesRatiosAndPicturesOfEveryScene)
{
    const Json json = quick_baseline().json["baseline"];
    std::set<std::string> scenes;
    for (const Json& row : json["rows"]) {
        scenes.insert(row["scene"].get<std::string>());
        EXPECT_EQ(row["width"], 64);
        std::set<std::string> sides;
        for (const Json& side : row["sides"]) {
            sides.insert(side["side"].get<std::string>());
            expect_sound_baseline(side["ms"]);
            EXPECT_GE(side["stages_ms"].size(), 5u);
        }
        EXPECT_TRUE(sides.count("ours, map") && sides.count("ours, exact"));
        EXPECT_EQ(sides.count("Embree, 8 rays") == 1, has_embree());
        if (!has_embree()) {
            EXPECT_FALSE(row["embree_unavailable"].get<std::string>().empty());
            continue;
        }
        EXPECT_FALSE(row["update"].get<std::string>().empty());
        ASSERT_GE(row["ratios"].size(), 2u);
        for (const Json& ratio : row["ratios"]) expect_sound_baseline(ratio["ratio"]);
        if (row["threads"] != 1) continue;
        for (const char* const shadows : {"exact", "map"}) {
            const Json& pictures = row["pictures"][shadows];
            EXPECT_EQ(pictures["pixels"], 64 * 48);
            EXPECT_LE(pictures["items"].get<int>(), 3) << row["scene"];
            EXPECT_LE(pictures["colors"].get<int>(), 60) << row["scene"];
        }
    }
    EXPECT_TRUE(scenes.count("torus") && scenes.count("torus, still") &&
                scenes.count("torus, twisting") && scenes.count("wave, 10^3"));
}

TEST(Baselines, AQuickRunHasItsSweepsAndWhatIsAsked)
{
    const Json json = quick_baseline().json["baseline"];
    ASSERT_EQ(json["asked"].size(), 1u);
    EXPECT_EQ(json["asked"][0]["scene"], "torus");
    EXPECT_EQ(json["asked"][0]["map"]["asked"], 8);
    EXPECT_EQ(json["asked"][0]["exact"]["asked"], 5);
    EXPECT_EQ(json["asked"][0]["map"].contains("measured"), has_embree());
    EXPECT_EQ(json["pixel_growth"][0]["rows"].size(), 2u);
    EXPECT_EQ(json["moving_share"]["shares"], Json::array({0, 0.1, 1}));
    EXPECT_EQ(json["moving_share"]["rows"].size(), 3u);
    EXPECT_GT(json["moving_share"]["all_against_none"]["ours, exact"].get<double>(), 0);
    const Json& gpu = json["gpu"]["rows"][0];
    EXPECT_TRUE(gpu.contains("ratio") || gpu.contains("unavailable"));
}

TEST(Baselines, ThePageShowsItsTablesAndCurves)
{
    const std::string page = to_text(quick_baseline().page.json());
    for (const char* const text : {"Asked and measured", "Frame time against pixels",
             "Frame time against the share", "Pixels that are not Embree"})
        EXPECT_EQ(page.find(text) != std::string::npos,
            has_embree() || !std::string(text).starts_with("Pixels"))
            << text;
    EXPECT_NE(quick_baseline().text.find("Whole frames, milliseconds: 64x48, 1 thread"),
        std::string::npos);
}

TEST(Baselines, TablesAreAsWideAsTheirHeadsAndCurvesHaveAYForEveryX)
{
    std::size_t tables = 0, curves = 0;
    const Json page = quick_baseline().page.json();
    for (const Json& part : page["parts"]) {
        if (part.contains("table")) {
            for (const Json& row : part["table"]["rows"])
                EXPECT_EQ(row.size(), part["table"]["head"].size()) << part["table"]["title"];
            ++tables;
        }
        if (part.contains("curves")) {
            for (const Json& series : part["curves"]["series"])
                for (const char* const column : {"y", "lower", "upper"})
                    EXPECT_EQ(series[column].size(), series["x"].size()) << series["name"];
            ++curves;
        }
    }
    EXPECT_GE(tables, 10u);
    EXPECT_GE(curves, 2u);
}

TEST(Baselines, AMissingSceneIsToldAndTheOthersAreMeasured)
{
    BenchOptions options;
    options.scenes = "nowhere";
    options.quick = true;
    const BaselineScene missing{
        .name = "bunny", .scene = nullptr, .note = "nowhere/bunny.stl is missing"};
    const BaselineRow row = measure_row(missing, {.size = {16, 16}});
    EXPECT_EQ(row_json(row)["unavailable"], "nowhere/bunny.stl is missing");
    Report report;
    add_frames_tables(std::vector<BaselineRow>{row}, "test", report);
    EXPECT_NE(report.text.find("nowhere/bunny.stl is missing"), std::string::npos);
}

TEST(BaselineScenes, MoveFromFrameToFrameUnlessTheyAreStill)
{
    BenchOptions options;
    options.quick = true;
    const std::vector<BaselineScene> scenes = baseline_scenes(options);
    for (const BaselineScene& scene : scenes) {
        World a, b;
        pose(scene.scene, round_time(scene, 0), a);
        pose(scene.scene, round_time(scene, 1), b);
        const bool moves = scene.name != "torus" && scene.name != "torus, still";
        EXPECT_EQ(a.position != b.position, moves) << scene.name;
        EXPECT_EQ(scene.moves(), moves) << scene.name;
        EXPECT_EQ(a.lights.size(), 1u);
        EXPECT_EQ(a.lights[0].position != b.lights[0].position, scene.name == "torus");
    }
    EXPECT_NE(find_scene(scenes, "torus, still"), nullptr);
    EXPECT_EQ(find_scene(scenes, "moon"), nullptr);
}

TEST(MovingScenes, TwistVerticesAndTheirNormalsAlike)
{
    const auto scene = std::make_shared<const Scene>(twisting(load_scene("builtin:torus")));
    World a, b;
    pose(scene, 0, a);
    pose(scene, 1, b);
    const auto [low, high] = bounds(a);
    const glm::vec3 middle = 0.5f * (low + high);
    std::size_t moved = 0;
    for (std::size_t v = 0; v < a.position.size(); ++v) {
        moved += a.position[v] != b.position[v];
        EXPECT_EQ(a.position[v].y, b.position[v].y);
        EXPECT_NEAR(glm::dot(a.normal[v], a.position[v] - middle),
            glm::dot(b.normal[v], b.position[v] - middle), 1e-4);
        EXPECT_NEAR(glm::length(b.normal[v]), 1, 1e-5);
    }
    EXPECT_GT(moved, a.position.size() * 3 / 4); // not those at half the height
}

TEST(MovingScenes, AShareOfTheClothMoves)
{
    for (const double share : {0.0, 0.1, 1.0}) {
        const auto scene = std::make_shared<const Scene>(partly_moving_cloth(20000, share));
        EXPECT_EQ(scene->triangle_count(), 20000u);
        World a, b;
        pose(scene, 0, a);
        pose(scene, 1, b);
        std::size_t moved = 0;
        for (std::size_t v = 0; v < a.position.size(); ++v) moved += a.position[v] != b.position[v];
        EXPECT_NEAR(double(moved) / double(a.position.size()), share, 0.06) << share;
        EXPECT_EQ(scene->instances.size(), share == 0.1 ? 2u : 1u);
        for (std::size_t t = 0; t < scene->index.size(); ++t) {
            const Instance& instance = scene->instances.at(scene->owner[t]);
            EXPECT_GE(t, instance.first_triangle);
            EXPECT_LT(t, instance.first_triangle + instance.triangle_count);
            // No triangle hangs between the two.
            for (int k = 0; k < 3; ++k) {
                EXPECT_GE(scene->index[t][k], instance.first_vertex);
                EXPECT_LT(scene->index[t][k], instance.first_vertex + instance.vertex_count);
            }
        }
    }
}

TEST(PictureDifference, CountsPixelsWhoseItemOrColourDiffers)
{
    Film a;
    a.width = 3;
    a.height = 1;
    a.color = {3, {0, 0, 0, 0.5f, 0.5f, 0.5f, 1, 1, 1}};
    a.item = {1, 2, kNoItem};
    Film b = a;
    EXPECT_EQ(difference(a, b).colors, 0u);
    b.item[2] = 7;
    b.color.value[3] = 0.501f; // within a code of the display
    b.color.value[8] = 0.9f;
    b.color.value[6] = 0.9f; // the same pixel
    const PictureDifference found = difference(a, b);
    EXPECT_EQ(found.pixels, 3u);
    EXPECT_EQ(found.items, 1u);
    EXPECT_EQ(found.colors, 1u);
    b.item.clear();
    EXPECT_THROW(difference(a, b), ArgumentError);
}

} // namespace
} // namespace firsthit::cli::bench
