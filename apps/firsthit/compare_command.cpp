// compare_command.cpp - `firsthit compare`: holds items and shadows against another ray caster.
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
  firsthit compare builtin:robots --against brute --shadows exact --size 256x256

Where two casters disagree, exact arithmetic settles who is right: "ties" are different triangles at
exactly the same depth. --json prints one object, summed over the frames:
  {"pixels", "agree", "ties", "ours_wrong", "theirs_wrong"}
--shadows exact also asks for every hit and light whether the light reaches the hit ("lit_pixels" are
hits times lights); brute force over all triangles settles who is right:
  {..., "lit_pixels", "lit_agree", "lit_ours_wrong", "lit_theirs_wrong"}
Exit codes: 0 done and nothing of ours is wrong, 1 failed or something is, 2 wrong usage.)";

Oracle parse_oracle(const std::string& text)
{
    if (text == "brute") return Oracle::brute;
    if (text == "embree") return Oracle::embree;
    throw UsageError(fmt::format("'{}' is no ray caster: accepted are brute and embree", text));
}

bool parse_lit(const std::string& text)
{
    if (text == "none") return false;
    if (text == "exact") return true;
    throw UsageError(fmt::format("'{}' cannot be compared: accepted are none and exact", text));
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
    add_parsed(app, "--shadows", options.shadows, parse_lit, "none|exact",
        "exact: compare which lights reach the hits, too; default none");
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

LitComparison operator+(const LitComparison& a, const LitComparison& b)
{
    return {
        .pixels = a.pixels + b.pixels,
        .agree = a.agree + b.agree,
        .ours_wrong = a.ours_wrong + b.ours_wrong,
        .theirs_wrong = a.theirs_wrong + b.theirs_wrong,
    };
}

Json comparison_json(const Comparison& comparison, const std::optional<LitComparison>& lit)
{
    Json json = {
        {"pixels", comparison.pixels},
        {"agree", comparison.agree},
        {"ties", comparison.ties},
        {"ours_wrong", comparison.ours_wrong},
        {"theirs_wrong", comparison.theirs_wrong},
    };
    if (lit) {
        json["lit_pixels"] = lit->pixels;
        json["lit_agree"] = lit->agree;
        json["lit_ours_wrong"] = lit->ours_wrong;
        json["lit_theirs_wrong"] = lit->theirs_wrong;
    }
    return json;
}

std::string comparison_text(const Comparison& comparison, const std::optional<LitComparison>& lit)
{
    std::string text = fmt::format("pixels           {:>12}\nagree            {:>12}\n"
                                   "ties             {:>12}\nours wrong       {:>12}\n"
                                   "theirs wrong     {:>12}\n",
        comparison.pixels, comparison.agree, comparison.ties, comparison.ours_wrong,
        comparison.theirs_wrong);
    if (lit)
        text += fmt::format("lit pixels       {:>12}\nlit agree        {:>12}\n"
                            "lit ours wrong   {:>12}\nlit theirs wrong {:>12}\n",
            lit->pixels, lit->agree, lit->ours_wrong, lit->theirs_wrong);
    return text;
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
    std::optional<LitComparison> lit;
    if (options.shadows) lit.emplace();
    {
        Progress progress("compared", times.size() * regions.size());
        for (const double time_s : times) {
            pose(scene, time_s, world);
            View view = views.view(world);
            for (const Region& region : regions) {
                view.region = region;
                sum = sum + compare(world, view, options.oracle, options.threads);
                if (lit) lit = *lit + compare_lit(world, view, options.oracle, options.threads);
                progress.advance();
            }
        }
    }
    print(options.json ? to_text(comparison_json(sum, lit)) : comparison_text(sum, lit));
    return sum.ours_wrong + (lit ? lit->ours_wrong : 0) == 0 ? kExitDone : kExitFailed;
}

} // namespace firsthit::cli
