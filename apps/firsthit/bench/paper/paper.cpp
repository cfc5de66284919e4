// paper.cpp - `firsthit bench --paper`: section 5 of Robert and Schoepke 2006, measured here.
#include "bench/paper/paper.h"

#include "bench/paper/figures.h"
#include "bench/paper/frames.h"
#include "bench/paper/numbers.h"
#include "bench/paper/pictures.h"
#include "bench/paper/tables.h"
#include "common/progress.h"

#include <fmt/format.h>

#include <algorithm>

namespace firsthit::cli::bench {

namespace {

constexpr int kRounds = 21;      // of the tables
constexpr int kCurvePoints = 50; // of figure 9
constexpr int kCurveRepeats = 3;
constexpr int kPictureSide = 480;

PaperMeasured measure_tables(std::vector<PaperScene> scenes, const BenchOptions& options)
{
    PaperMeasured measured{.scenes = std::move(scenes), .ways = paper_ways(), .frames = {}};
    PaperRenderers renderers(measured.ways, options.threads);
    const int rounds = rounds_of(options, kRounds);
    for (std::size_t k = 0; k < measured.scenes.size(); ++k) {
        measured.frames.emplace_back();
        if (!measured.scenes[k].scene) continue;
        Progress progress(fmt::format("tables: {}", kPaperNames[k]),
            measured.ways.size() * std::size_t(rounds + PaperRenderers::kWarmUp));
        measured.frames.back() = renderers.measure(
            measured.scenes[k], size_of(options), rounds, 1, [&] { progress.advance(); });
    }
    return measured;
}

void measure_animation(
    const PaperScene& robots, const BenchOptions& options, Report& report, Json& json)
{
    PaperRenderers renderers(animation_ways(), options.threads);
    const int points = options.quick ? 4 : kCurvePoints;
    const int repeats = options.quick ? 1 : kCurveRepeats;
    Progress progress("figure 9",
        renderers.ways().size() * std::size_t(points * repeats + PaperRenderers::kWarmUp));
    const std::vector<Frames> frames =
        renderers.measure(robots, size_of(options), points, repeats, [&] { progress.advance(); });
    add_animation(robots, frames, points, report, json);
}

void say_how(const BenchOptions& options, int threads, Report& report)
{
    const Size size = size_of(options);
    report.page.paragraph(fmt::format(
        "What section 5 of the paper measures ({}), on its three scenes, with one light. Its "
        "numbers "
        "are quoted beside ours. It does not say how many pixels its pictures have, nor which rays "
        "its interleaving shoots: ours have {}x{}, and every {}nd ray is shot. It was measured on "
        "{}.",
        kPaper, size.width, size.height, kPaperInterleave, kPaperMachine));
    report.page.paragraph(fmt::format(
        "The paper's CPU ray tracer, which has OpenGL draw the items, is our hybrid engine; its "
        "GPU ray "
        "tracer is our gpu engine. Our cpu engine makes its own items, needs no OpenGL, and is "
        "exact. "
        "Every number is the median of {} frames, with quartiles below it: whole frames, from "
        "posing "
        "the scene to the picture in memory, {} thread{}, all ways in turn frame by frame in one "
        "process. Still scenes keep their shadow map, as in the paper; the robots are gone through "
        "from "
        "begin to end. Pixels whose triangle is not found are interpolated. Where OpenGL is a "
        "software "
        "driver, hybrid and gpu frames are made by the same cores as the others.",
        rounds_of(options, kRounds), threads, threads == 1 ? "" : "s"));
}

} // namespace

void add_paper(const BenchOptions& options, Report& report)
{
    std::vector<PaperScene> scenes = paper_scenes(options);
    const Size size = size_of(options);
    const int threads = Renderer(options.threads).threads();
    report.page.heading("The paper's section 5");
    say_how(options, threads, report);
    Json json = {{"source", kPaper}, {"paper_machine", kPaperMachine}, {"width", size.width},
        {"height", size.height}, {"threads", threads}, {"rounds", rounds_of(options, kRounds)},
        {"interleave", kPaperInterleave}};

    const PaperMeasured measured = measure_tables(std::move(scenes), options);
    report.page.subheading("Tables");
    add_paper_tables(measured, report, json);
    report.page.subheading("Where the time goes, and how it varies");
    add_time_shares(measured, report, json);
    measure_animation(measured.scenes[0], options, report, json);
    report.page.subheading("Pictures");
    add_paper_pictures(
        measured.scenes, options.quick ? 64 : kPictureSide, options.threads, report, json);
    report.json["paper"] = std::move(json);
}

} // namespace firsthit::cli::bench
