// baseline.cpp - `firsthit bench --baseline`: the cpu engine's frames beside Embree's.
#include "bench/baseline/baseline.h"

#include "bench/baseline/engines.h"
#include "bench/baseline/frames.h"
#include "bench/baseline/sweeps.h"
#include "bench/baseline/tables.h"

#include <fmt/format.h>

#include <algorithm>

namespace firsthit::cli::bench {

namespace {

constexpr int kRounds = 15;

void say_how(const BenchOptions& options, Report& report)
{
    const Size size = size_of(options);
    report.page.paragraph(fmt::format(
        "Whole frames of the cpu engine, with shadow maps and with exact shadows, "
        "beside the same frames "
        "by {}: the same posed scenes, views, light, shading and film, in the same "
        "process, frame by frame "
        "in turn at the same times, {}x{} unless something else is said. The numbers "
        "that are asked for "
        "are against packets of 8 coherent rays, from the eye and towards the light. "
        "Where a processor "
        "has AVX-512, Embree is quicker with packets of 16: that is measured too.",
        baseline_version().empty() ? "Embree (of which this build has none)" : baseline_version(),
        size.width, size.height));
    report.page.paragraph("Embree's tree is updated by the quickest of refitting, refitting part "
                          "by part and building anew, "
                          "at low or medium quality, tried before; its positions are shared with "
                          "it, not copied. Ours makes "
                          "everything anew in every frame, but for shadow maps, which stay where "
                          "nothing has changed. So a "
                          "still mesh is measured twice: with a light that moves a little and a "
                          "tree that is updated in "
                          "every frame; and, \"still\", with a map that is kept and a tree of the "
                          "highest quality that is "
                          "made beforehand and not counted.");
}

std::vector<BaselineRow> measure_rows(const std::vector<BaselineScene>& scenes,
    const BenchOptions& options, const Size& size, int threads, bool pictures)
{
    std::vector<BaselineRow> rows;
    for (const BaselineScene& scene : scenes)
        rows.push_back(measure_row(scene, {.size = size,
                                              .threads = threads,
                                              .rounds = rounds_of(options, kRounds),
                                              .fewer = !options.rounds,
                                              .pictures = pictures}));
    return rows;
}

std::vector<BaselineScene> named(
    const std::vector<BaselineScene>& scenes, std::initializer_list<const char*> names)
{
    std::vector<BaselineScene> found;
    for (const char* const name : names)
        if (const BaselineScene* scene = find_scene(scenes, name)) found.push_back(*scene);
    return found;
}

std::vector<BaselineScene> robots(const std::vector<BaselineScene>& scenes)
{
    return named(scenes, {"Robot.aff, t = 10", "Robot.aff, t = 30", "Robot.aff, t = 45",
                             "robots, t = 2.5", "robots, t = 5", "robots, t = 7.5"});
}

std::vector<BaselineRow> waves(const std::vector<BaselineRow>& rows)
{
    std::vector<BaselineRow> found;
    for (const BaselineRow& row : rows)
        if (row.scene.starts_with("wave")) found.push_back(row);
    return found;
}

/// Everything at other sizes and on all threads: of --full.
void add_all_sizes(const std::vector<BaselineScene>& scenes, const BenchOptions& options,
    int threads, Report& report, Json& list)
{
    for (const Size& size : {Size{512, 512}, Size{1448, 1448}, Size{2048, 2048}, Size{2896, 2896}})
        for (const int count : {1, threads}) {
            const std::vector<BaselineRow> rows = measure_rows(scenes, options, size, count, true);
            add_frames_tables(rows,
                fmt::format(
                    "{}x{}, {} thread{}", size.width, size.height, count, count == 1 ? "" : "s"),
                report);
            for (const BaselineRow& row : rows) list.push_back(row_json(row));
            if (threads == 1) break; // that was all
        }
}

} // namespace

void add_baseline(const BenchOptions& options, Report& report)
{
    const Size size = size_of(options);
    const int threads = Renderer(options.threads).threads();
    const std::vector<BaselineScene> scenes = baseline_scenes(options);
    report.page.heading("Beside Embree");
    say_how(options, report);
    Json json = {{"embree", baseline_version()}, {"width", size.width}, {"height", size.height},
        {"rounds", rounds_of(options, kRounds)}};
    Json list = Json::array();
    const std::string pixels = fmt::format("{}x{}, ", size.width, size.height);

    const std::vector<BaselineRow> rows = measure_rows(scenes, options, size, 1, true);
    add_asked_table(scenes, rows, report, json);
    add_frames_tables(rows, pixels + "1 thread", report);
    add_stages_table(rows, report);
    for (const BaselineRow& row : rows) list.push_back(row_json(row));

    report.page.subheading("Growth");
    add_triangle_growth(waves(rows), report, json);
    add_pixel_growth(options.quick
                         ? named(scenes, {"torus"})
                         : named(scenes, {"bunny, twisting", "Robot.aff, t = 30", "robots, t = 5"}),
        options, report, json);
    add_moving_shares(options, report, json);

    report.page.subheading("Threads and engines");
    if (threads > 1) {
        std::vector<BaselineScene> some = scenes;
        if (!options.full)
            std::erase_if(
                some, [](const BaselineScene& scene) { return scene.name == "wave, 10^7"; });
        const std::vector<BaselineRow> threaded = measure_rows(some, options, size, threads, false);
        add_frames_tables(threaded, fmt::format("{}{} threads", pixels, threads), report);
        for (const BaselineRow& row : threaded) list.push_back(row_json(row));
        add_threads(options.quick ? named(scenes, {"torus"}) : robots(scenes), options, threads,
            report, json);
    }
    add_gpu(options.quick ? named(scenes, {"torus"})
                          : named(scenes, {"torus", "bunny, twisting", "Robot.aff, t = 30",
                                              "robots, t = 5", "dragon"}),
        options, threads, report, json);
    if (options.full) {
        report.page.subheading("All sizes");
        add_all_sizes(scenes, options, threads, report, list);
    }
    json["rows"] = std::move(list);
    report.json["baseline"] = std::move(json);
}

} // namespace firsthit::cli::bench
