// compare_command.cpp - `firsthit compare`: holds items and shadows against another ray caster, or an
// engine on OpenGL against the cpu engine.
#include "compare_command.h"

#include "engine_report.h"
#include "inputs/scene_source.h"
#include "common/add_parsed.h"
#include "common/output.h"
#include "common/parse.h"
#include "common/progress.h"
#include "common/usage.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace firsthit::cli {

namespace {

constexpr const char* kCompareExamples = R"(Examples:
  firsthit compare builtin:torus --against brute --size 512x512
  firsthit compare Robot.aff --against embree --time 10
  firsthit compare builtin:robots --against embree --frames 0:9:10 --json
  firsthit compare builtin:robots --against brute --shadows exact --size 256x256
  firsthit compare builtin:robots --engine hybrid --against cpu --multisample none

Where two casters disagree, exact arithmetic decides who is right: "ties" are different triangles at
exactly the same depth. --json prints one object, summed over the frames:
  {"pixels", "agree", "ties", "ours_wrong", "theirs_wrong"}
--shadows exact also asks for every hit and light whether the light reaches the hit ("lit_pixels" are
hits times lights); brute force over all triangles decides who is right:
  {..., "lit_pixels", "lit_agree", "lit_ours_wrong", "lit_theirs_wrong"}
--against cpu holds an engine on OpenGL against the cpu engine, items and pictures, summed over the
frames:
  {"pixels", "missed", "wrong", "ties", "interpolated", "psnr_db", "largest_difference", "device"}
"missed" are pixels where only the cpu engine sees a triangle, "wrong" those where the engine sees
one that is not the cpu engine's. Pictures are compared by displayed values, 0 to 1 (sRGB); psnr_db
is null where they are equal. --engine gpu adds "psnr_same_items_db": the picture that it makes of the
cpu engine's items and shadow maps. --shadows none, map (default) or exact is for both engines.
Exit codes: 0 done and nothing of ours is wrong, 1 failed or something is, 2 wrong usage. Of engines
on OpenGL only --multisample exact can be wrong.)";

/// Nothing: the cpu engine.
std::optional<Oracle> parse_oracle(const std::string& text)
{
    if (text == "brute") return Oracle::brute;
    if (text == "embree") return Oracle::embree;
    if (text == "cpu") return std::nullopt;
    throw UsageError(
        fmt::format("'{}' cannot be compared with: accepted are brute, embree and cpu", text));
}

constexpr int kBands = 16;

/// The picture cut into bands, so that slow work shows how far it is. Brute force takes as long in
/// bands as at once; Embree would build its structure again for each, so it gets one.
std::vector<Region> bands(const View& view, Oracle oracle)
{
    Region all = view.region;
    if (all.width == 0) all.width = view.width - all.x;
    if (all.height == 0) all.height = view.height - all.y;
    if (oracle == Oracle::embree || all.width < 1 || all.height < 1) return {all};
    const int count = std::min(all.height, kBands);
    std::vector<Region> regions;
    for (int k = 0; k < count; ++k) {
        const int y = static_cast<int>(std::int64_t(all.height) * k / count);
        const int end = static_cast<int>(std::int64_t(all.height) * (k + 1) / count);
        regions.push_back({.x = all.x, .y = all.y + y, .width = all.width, .height = end - y});
    }
    return regions;
}

} // namespace

void add_compare_options(CLI::App& app, CompareOptions& options)
{
    add_scene_options(app, options.scene);
    add_parsed(app, "--against", options.oracle, parse_oracle, "brute|embree|cpu",
        "brute: every triangle for every pixel with exact arithmetic; embree: Embree 3, robust; "
        "cpu: the cpu engine, for --engine hybrid or gpu")
        ->required();
    add_parsed(app, "--engine", options.engine.engine, parse_engine, "cpu|hybrid|gpu",
        "Whose picture is compared; default cpu");
    add_parsed(app, "--shadows", options.shadows, parse_shadows, "none|map|exact",
        "With brute and embree, exact: compare which lights reach the hits, too; default none. "
        "With cpu: the pictures' shadows; default map");
    add_light_option(app, options.light);
    add_picture_set_options(app, options);
    add_engine_options(app, options.engine);
    app.add_flag("--json", options.json, "Print one JSON object");
    app.footer(kCompareExamples);
}

void check(const CompareOptions& options)
{
    const Engine engine = options.engine.engine;
    if (options.oracle) {
        if (engine != Engine::cpu)
            throw UsageError(
                fmt::format("--engine {} is compared with --against cpu", engine_name(engine)));
        if (options.shadows == Shadows::map)
            throw UsageError("--shadows: 'map' cannot be compared: accepted are none and exact");
        return;
    }
    if (engine != Engine::hybrid && engine != Engine::gpu)
        throw UsageError(fmt::format(
            "--against cpu needs an engine on OpenGL, not {}: say --engine hybrid or --engine gpu",
            engine_name(engine)));
    if (engine == Engine::gpu && options.shadows == Shadows::exact)
        throw UsageError("--engine gpu has no exact shadows: accepted are none and map");
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

namespace {

int compare_with_oracle(const CompareOptions& options, SceneSource& source)
{
    PoseSettings chosen = pose_settings(options.scene.pose, *source.first());
    const Frames frames = frames_of(options, options.frames, *source.first(), chosen);
    ViewMaker views(options.camera, options.scene.shown_name());
    World world;
    Comparison sum;
    std::optional<LitComparison> lit;
    if (options.shadows == Shadows::exact) lit.emplace();
    {
        const Oracle oracle = *options.oracle;
        Progress progress("compared", frames.size() * (oracle == Oracle::embree ? 1 : kBands));
        for (std::size_t k = 0; k < frames.size(); ++k) {
            chosen.time_s = frames.time_s[k];
            pose(source.scene_at(chosen.time_s), chosen, world);
            View view = views.view(world, k);
            for (const Region& region : bands(view, oracle)) {
                view.region = region;
                sum = sum + compare(world, view, oracle, options.threads);
                if (lit) lit = *lit + compare_lit(world, view, oracle, options.threads);
                progress.advance();
            }
        }
    }
    print(options.json ? to_text(comparison_json(sum, lit)) : comparison_text(sum, lit));
    return sum.ours_wrong + (lit ? lit->ours_wrong : 0) == 0 ? kExitDone : kExitFailed;
}

int compare_with_cpu(const CompareOptions& options, SceneSource& source)
{
    Settings settings;
    settings.shadows = options.shadows;
    apply(options.engine, settings);
    PoseSettings chosen = pose_settings(options.scene.pose, *source.first());
    const Frames frames = frames_of(options, options.frames, *source.first(), chosen);
    ViewMaker views(options.camera, options.scene.shown_name());
    EngineComparer comparer(options.threads);
    World world;
    EngineComparison sum;
    {
        Progress progress("compared", frames.size());
        for (std::size_t k = 0; k < frames.size(); ++k) {
            chosen.time_s = frames.time_s[k];
            pose(source.scene_at(chosen.time_s), chosen, world);
            sum = sum + comparer.compare(world, views.view(world, k), settings);
            progress.advance();
        }
    }
    print(options.json ? to_text(engine_comparison_json(sum, comparer.device()))
                       : engine_comparison_text(sum, comparer.device()));
    const bool wrong = sum.missed + sum.wrong > 0;
    return wrong && settings.multisample == Multisample::exact ? kExitFailed : kExitDone;
}

} // namespace

int run_compare(const CompareOptions& given)
{
    check(given);
    CompareOptions options = given;
    read_files(options);
    turn_suns(
        options.camera.up_axis.value_or(usual_up_axis(options.scene.shown_name())), options.light);
    options.scene.fps_of_frames = options.frames.clip || !options.frames.numbers.empty();
    SceneSource source(options.scene, [&](Scene& scene) { apply(options.light, scene); });
    take_size(*source.first(), options.camera);
    return options.oracle ? compare_with_oracle(options, source)
                          : compare_with_cpu(options, source);
}

} // namespace firsthit::cli
