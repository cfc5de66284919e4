// engines.cpp - our own engines beside each other: threads, and OpenGL.
#include "bench/baseline/engines.h"

#include "bench/baseline/frame_maker.h"
#include "bench/baseline/picture_difference.h"
#include "bench/measure/quartiles.h"
#include "common/progress.h"

#include <fmt/format.h>

#include <optional>

namespace firsthit::cli::bench {

namespace {

constexpr int kThreadRounds = 31, kGpuRounds = 7;
constexpr double kAskedThreads = 1.85; // two threads against one
constexpr double kAskedGpu = 4;

/// Two ways to make the same frames.
struct Pair {
    Quartiles first, second; // ms
    Quartiles ratio;         // second / first, round by round
    std::string failure;     // of the second
    std::optional<PictureDifference> pictures;
};

Pair measure_pair(const BaselineScene& scene, const std::string& label, FrameMaker& first,
    FrameMaker& second, int rounds)
{
    const std::vector<Contender> contenders{
        contender("first", scene, first), contender("second", scene, second)};
    Progress progress(label, 2 * std::size_t(rounds + FrameMaker::kWarmUp));
    const std::vector<Times> times =
        measure_in_turn(contenders, rounds, FrameMaker::kWarmUp, [&] { progress.advance(); });
    Pair pair{.first = quartiles(times[0].ms),
        .second = quartiles(times[1].ms),
        .ratio = {},
        .failure = times[1].failure,
        .pictures = {}};
    std::vector<double> ratios;
    for (std::size_t k = 0; k < times[1].ms.size(); ++k)
        ratios.push_back(times[1].ms[k] / times[0].ms[k]);
    pair.ratio = quartiles(std::move(ratios));
    if (!pair.failure.empty()) return pair;
    first.frame(round_time(scene, rounds), true);
    second.frame(round_time(scene, rounds), true);
    pair.pictures = difference(first.film(), second.film());
    return pair;
}

Json pair_json(const BaselineScene& scene, const Pair& pair, double asked)
{
    Json json = {{"scene", scene.name}, {"ms", quartiles_json(pair.first)}};
    if (!pair.failure.empty()) {
        json["unavailable"] = pair.failure;
        return json;
    }
    json["other_ms"] = quartiles_json(pair.second);
    json["ratio"] = quartiles_json(pair.ratio);
    if (asked > 0) json["asked"] = asked;
    if (pair.pictures) json["pictures"] = difference_json(*pair.pictures);
    return json;
}

std::vector<Cell> pair_cells(const std::string& name, const Pair& pair, double asked)
{
    std::vector<Cell> cells{{name}, cell(pair.first)};
    if (!pair.failure.empty()) {
        cells.push_back(missing_cell(pair.failure));
        cells.resize(6, {"-"});
        return cells;
    }
    cells.push_back(cell(pair.second));
    cells.push_back(cell(pair.ratio));
    cells.push_back({asked > 0 ? fmt::format("{:g}", asked) : ""});
    cells.push_back({fmt::format("{} items, {} colours", pair.pictures ? pair.pictures->items : 0,
        pair.pictures ? pair.pictures->colors : 0)});
    return cells;
}

} // namespace

void add_threads(std::span<const BaselineScene> scenes, const BenchOptions& options, int threads,
    Report& report, Json& json)
{
    Table table{.title = fmt::format("The cpu engine on {} threads against one", threads),
        .head = {"scene", fmt::format("{} threads, ms", threads), "1 thread, ms", "times as fast",
            "asked", "pixels that differ"},
        .rows = {},
        .note =
            "Medians, quartiles beneath. The pictures are the same bits, whatever the threads."};
    Json list = Json::array();
    for (const BaselineScene& scene : scenes) {
        for (const Shadows shadows : {Shadows::map, Shadows::exact}) {
            Settings settings;
            settings.shadows = shadows;
            const auto many = our_frames(scene, size_of(options), threads, settings),
                       one = our_frames(scene, size_of(options), 1, settings);
            const Pair pair = measure_pair(
                scene, "threads: " + scene.name, *many, *one, rounds_of(options, kThreadRounds));
            const char* const kind = shadows == Shadows::map ? "map" : "exact";
            const double asked = threads == 2 ? kAskedThreads : 0;
            Json entry = pair_json(scene, pair, asked);
            entry["shadows"] = kind;
            list.push_back(std::move(entry));
            table.rows.push_back(pair_cells(fmt::format("{}: {}", scene.name, kind), pair, asked));
        }
    }
    report.add(table);
    json["threads"] = {{"threads", threads}, {"rows", std::move(list)}};
}

void add_gpu(std::span<const BaselineScene> scenes, const BenchOptions& options, int threads,
    Report& report, Json& json)
{
    Table table{
        .title = fmt::format("The cpu engine against the gpu engine, shadow maps, {} thread{}",
            threads, threads == 1 ? "" : "s"),
        .head = {"scene", "cpu, ms", "gpu, ms", "times as fast", "asked", "pixels that differ"},
        .rows = {},
        .note = "The same picture by the two engines. What OpenGL runs on stands below; a software "
                "driver "
                "has all cores, whatever the threads of the cpu engine. The numbers that are asked "
                "for are "
                "for such a driver."};
    Json list = Json::array();
    for (const BaselineScene& scene : scenes) {
        Settings settings;
        settings.shadows = Shadows::map;
        const auto cpu = our_frames(scene, size_of(options), threads, settings);
        settings.engine = Engine::gpu;
        const auto gpu = our_frames(scene, size_of(options), threads, settings);
        const Pair pair =
            measure_pair(scene, "gpu: " + scene.name, *cpu, *gpu, rounds_of(options, kGpuRounds));
        list.push_back(pair_json(scene, pair, kAskedGpu));
        table.rows.push_back(pair_cells(scene.name, pair, kAskedGpu));
    }
    report.add(table);
    json["gpu"] = {{"threads", threads}, {"rows", std::move(list)}};
}

} // namespace firsthit::cli::bench
