// sweeps.cpp - how frame times grow: with triangles, with pixels, with the share that moves.
#include "bench/baseline/sweeps.h"

#include "bench/baseline/moving_scenes.h"
#include "bench/baseline/tables.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

namespace firsthit::cli::bench {

namespace {

constexpr int kRounds = 9;
/// All rows here have one thread.
constexpr const char* kMilliseconds = "milliseconds of the processor's time";

/// A curve for each side over the rows.
Json curves(std::span<const BaselineRow> rows, const std::function<double(std::size_t)>& x)
{
    Json series = Json::array();
    for (const Side side : kSides) {
        Json curve = {{"name", std::string(side_name(side))}};
        for (std::size_t k = 0; k < rows.size(); ++k)
            if (const SideTimes* times = rows[k].find(side)) {
                curve["x"].push_back(x(k));
                curve["y"].push_back(times->cpu_ms.median);
                curve["lower"].push_back(times->cpu_ms.lower);
                curve["upper"].push_back(times->cpu_ms.upper);
            }
        if (curve.contains("x")) series.push_back(std::move(curve));
    }
    return series;
}

/// The power of x that the time grows by, from the first row to the last. 1: linear; below: a part of the
/// time does not grow.
Json exponents_json(std::span<const BaselineRow> rows, const std::function<double(std::size_t)>& x)
{
    Json json = Json::object();
    for (const Side side : kSides) {
        if (rows.size() < 2) continue;
        const SideTimes *first = rows.front().find(side), *last = rows.back().find(side);
        if (first && last && first->cpu_ms.median > 0)
            json[std::string(side_name(side))] =
                std::log(last->cpu_ms.median / first->cpu_ms.median) /
                std::log(x(rows.size() - 1) / x(0));
    }
    return json;
}

Json rows_json(std::span<const BaselineRow> rows)
{
    Json json = Json::array();
    for (const BaselineRow& row : rows) json.push_back(row_json(row));
    return json;
}

std::vector<Size> sizes(const BenchOptions& options)
{
    if (options.quick) return {{32, 32}, {64, 64}};
    // 0.25, 1, 2, 4 and 8 megapixels.
    return {{512, 512}, {1024, 1024}, {1448, 1448}, {2048, 2048}, {2896, 2896}};
}

} // namespace

void add_triangle_growth(std::span<const BaselineRow> rows, Report& report, Json& json)
{
    const auto triangles = [&](std::size_t k) { return double(rows[k].triangles); };
    if (rows.size() < 2) return;
    report.page.add_curves({{"title", "Frame time against triangles"},
        {"x", {{"label", "triangles"}, {"log", true}}},
        {"y", {{"label", kMilliseconds}, {"log", true}}}, {"series", curves(rows, triangles)},
        {"caption", fmt::format("The wave, whose every vertex moves in every frame, at {}x{}, {} "
                                "thread{}. Bars: quartiles.",
                        rows[0].size.width, rows[0].size.height, rows[0].threads,
                        rows[0].threads == 1 ? "" : "s")}});
    json["triangle_growth"] = {{"exponents", exponents_json(rows, triangles)}};
}

void add_pixel_growth(
    std::span<const BaselineScene> scenes, const BenchOptions& options, Report& report, Json& json)
{
    Json list = Json::array();
    for (const BaselineScene& scene : scenes) {
        std::vector<BaselineRow> rows;
        for (const Size& size : sizes(options)) {
            rows.push_back(measure_row(scene, {.size = size,
                                                  .threads = 1,
                                                  .rounds = rounds_of(options, kRounds),
                                                  .fewer = !options.rounds,
                                                  .pictures = true}));
            rows.back().scene = fmt::format("{}, {}x{}", scene.name, size.width, size.height);
        }
        const auto megapixels = [&](std::size_t k) {
            return double(rows[k].size.width) * double(rows[k].size.height) / 1e6;
        };
        report.page.add_curves({{"title", "Frame time against pixels: " + scene.name},
            {"x", {{"label", "megapixels"}}}, {"y", {{"label", kMilliseconds}}},
            {"series", curves(rows, megapixels)}, {"caption", "One thread. Bars: quartiles."}});
        add_frames_tables(rows, "1 thread", report);
        list.push_back({{"scene", scene.name}, {"exponents", exponents_json(rows, megapixels)},
            {"rows", rows_json(rows)}});
    }
    json["pixel_growth"] = std::move(list);
}

void add_moving_shares(const BenchOptions& options, Report& report, Json& json)
{
    const std::uint64_t triangles = options.quick ? 2000 : 1000000;
    const std::vector<double> shares = options.full
                                           ? std::vector<double>{0, 0.01, 0.1, 0.25, 0.5, 1}
                                           : std::vector<double>{0, 0.1, 1};
    std::vector<BaselineScene> cloths;
    for (const double share : shares)
        cloths.push_back(baseline_scene(fmt::format("cloth, {:g} % moves", 100 * share),
            with_moving_lights(partly_moving_cloth(triangles, share))));
    const std::vector<BaselineRow> rows =
        measure_together(cloths, {.size = size_of(options),
                                     .threads = 1,
                                     .rounds = rounds_of(options, kRounds),
                                     .fewer = !options.rounds,
                                     .pictures = true});
    report.page.add_curves({{"title", "Frame time against the share of the vertices that move"},
        {"x", {{"label", "share of the vertices that move, %"}}}, {"y", {{"label", kMilliseconds}}},
        {"series", curves(rows, [&](std::size_t k) { return 100 * shares[k]; })},
        {"caption",
            "A cloth, one thread, all shares in turn. The light moves a little, so that our shadow "
            "map is made in every frame. Embree is told which part moves, and updates no more than "
            "that where this is quickest."}});
    add_frames_tables(rows, "a cloth of which a share moves, 1 thread", report);
    Json flat = Json::object();
    for (const Side side : kSides) {
        const SideTimes *none = rows.front().find(side), *all = rows.back().find(side);
        if (none && all && none->cpu_ms.median > 0)
            flat[std::string(side_name(side))] = all->cpu_ms.median / none->cpu_ms.median;
    }
    json["moving_share"] = {
        {"shares", shares}, {"all_against_none", std::move(flat)}, {"rows", rows_json(rows)}};
}

} // namespace firsthit::cli::bench
