// compare_command.cpp - `firsthit compare`: holds the item buffer against another ray caster.
#include "compare_command.h"

#include "output.h"
#include "parse.h"
#include "progress.h"
#include "usage.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace firsthit::cli {

namespace {

constexpr const char* kExamples = R"(Examples:
  firsthit compare builtin:torus --against brute --size 512x512
  firsthit compare Robot.aff --against embree --time 10
  firsthit compare builtin:robots --against embree --frames 0:9:10 --json

Where two casters disagree, exact arithmetic settles who is right: "ties" are different triangles at
exactly the same depth. --json prints one object, summed over the frames:
  {"pixels", "agree", "ties", "ours_wrong", "theirs_wrong"}
Exit codes: 0 done and ours_wrong is 0, 1 failed or ours_wrong is not 0, 2 wrong usage.)";

Oracle parse_oracle(const std::string& text)
{
    if (text == "brute") return Oracle::brute;
    if (text == "embree") return Oracle::embree;
    throw UsageError(fmt::format("'{}' is no ray caster: accepted are brute and embree", text));
}

/// The picture cut into bands, so that slow work shows how far it is. Brute force takes as long in
/// bands as at once; Embree would build its structure again for each, so it gets one.
std::vector<Region> bands(const CompareOptions& options)
{
    const Size size = options.camera.size;
    const int count = options.oracle == Oracle::brute ? std::min(size.height, 16) : 1;
    std::vector<Region> regions;
    for (int k = 0; k < count; ++k) {
        const int y = static_cast<int>(std::int64_t(size.height) * k / count);
        const int end = static_cast<int>(std::int64_t(size.height) * (k + 1) / count);
        regions.push_back({.x = 0, .y = y, .width = size.width, .height = end - y});
    }
    return regions;
}

} // namespace

void add_compare_options(CLI::App& app, CompareOptions& options)
{
    add_scene_options(app, options.scene);
    add_parsed(app, "--against", options.oracle, parse_oracle, "brute|embree",
        "brute: every triangle for every pixel with exact arithmetic; embree: Embree 3, robust")
        ->required();
    CLI::Option* time = add_parsed(app, "--time", options.time_s, parse_number, "S",
        "Seconds; default the begin of the scene's animation");
    add_parsed(app, "--frames", options.frames, parse_frames, "A:B:N",
        "N frames from time A to time B, both included; counts are summed")
        ->excludes(time);
    add_camera_options(app, options.camera);
    add_parsed(
        app, "--threads", options.threads,
        [](const std::string& text) { return parse_integer(text, 0, 1024); }, "N",
        "Threads, 0 to 1024; default 0: one for each core");
    app.add_flag("--json", options.json, "Print one JSON object");
    app.footer(kExamples);
}

Comparison operator+(const Comparison& a, const Comparison& b)
{
    return {
        .pixels = a.pixels + b.pixels,
        .agree = a.agree + b.agree,
        .ties = a.ties + b.ties,
        .ours_wrong = a.ours_wrong + b.ours_wrong,
        .theirs_wrong = a.theirs_wrong + b.theirs_wrong,
    };
}

Json comparison_json(const Comparison& comparison)
{
    return {
        {"pixels", comparison.pixels},
        {"agree", comparison.agree},
        {"ties", comparison.ties},
        {"ours_wrong", comparison.ours_wrong},
        {"theirs_wrong", comparison.theirs_wrong},
    };
}

std::string comparison_text(const Comparison& comparison)
{
    return fmt::format("pixels       {:>12}\nagree        {:>12}\nties         {:>12}\n"
                       "ours wrong   {:>12}\ntheirs wrong {:>12}\n",
        comparison.pixels, comparison.agree, comparison.ties, comparison.ours_wrong,
        comparison.theirs_wrong);
}

int run_compare(const CompareOptions& options)
{
    const Scene scene = load(options.scene);
    const std::vector<double> times =
        options.frames.empty() ? std::vector<double>{options.time_s.value_or(scene.begin_s)}
                               : options.frames;
    const std::vector<Region> regions = bands(options);
    ViewMaker views(options.camera);
    World world;
    Comparison sum;
    {
        Progress progress("compared", times.size() * regions.size());
        for (const double time_s : times) {
            pose(scene, time_s, world);
            View view = views.view(world);
            for (const Region& region : regions) {
                view.region = region;
                sum = sum + compare(world, view, options.oracle, options.threads);
                progress.advance();
            }
        }
    }
    print(options.json ? to_text(comparison_json(sum)) : comparison_text(sum));
    return sum.ours_wrong == 0 ? kExitDone : kExitFailed;
}

} // namespace firsthit::cli
