// cast_command.cpp - `firsthit cast`: what do any rays hit?
#include "cast_command.h"

#include "common/add_parsed.h"
#include "common/interrupt.h"
#include "common/output.h"
#include "common/parse.h"
#include "common/stopwatch.h"
#include "common/usage.h"
#include "inputs/scene_source.h"

#include <firsthit/error.h>
#include <firsthit/file.h>
#include <firsthit/render.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace firsthit::cli {

namespace {

constexpr const char* kCastExamples = R"(Examples:
  python3 -c 'import numpy; numpy.save("rays.npy", [[-1.2, 5, 0.6, 0, -1, 0], [0, 1, 9, 0, 0, -1]])'
  firsthit cast builtin:robots --rays rays.npy -o hits.npz
  firsthit cast bunny.stl --origins eye.npy --directions beams.npy --tmax 50 -o scan.npz
  firsthit cast bunny.stl --rays rays.npy --count -o crossings.npz

Rays are float32 or float64, rounded to float32: subtract what is large from scene and rays before.
--rays is (N, 6): origin, then direction of any length. --origins and --directions are (N, 3), one
of them perhaps (1, 3). Read the output with numpy.load:
  t         float32 (N,)    origin + t direction is the hit; inf where nothing is hit
  triangle  uint32 (N,)     4294967295 where nothing is hit, also in instance
  instance  uint32 (N,)     the object that the triangle belongs to
  uv        float32 (N, 2)  weights of the triangle's corners 1 and 2
  normal    float32 (N, 3)  unit; the triangle's corners are counter-clockwise around it
  --any     hit bool (N,)   instead: whether the ray hits anything
  --count   count uint32 (N,)  instead: how many triangles it hits
  --all     the five of all hits, ray by ray in the order of t, and first uint64 (N + 1,): the hits of
            ray k are first[k] to first[k + 1] - 1
A ray that is not finite or has no direction hits nothing. --skip names the triangle that each ray
does not hit: uint32, int32, uint64 or int64 (N,), -1 or 4294967295 for none. Exit codes: 0 done,
1 failed, 2 wrong usage.)";

float parse_t(const std::string& text)
{
    if (text == "inf") return std::numeric_limits<float>::infinity();
    return float(parse_number(text));
}

void check(const CastOptions& options)
{
    const RayFiles& files = options.files;
    if (files.rays.empty() && files.origins.empty())
        throw UsageError("no rays: say which with --rays, or with --origins and --directions");
    if (std::filesystem::path(options.output).extension() != ".npz")
        throw UsageError(fmt::format("'{}': accepted is .npz", options.output));
    if (files.t_min > files.t_max)
        throw UsageError(fmt::format(
            "--tmin {} is beyond --tmax {}: nothing is between", files.t_min, files.t_max));
    check_output_path(options.output);
}

/// throws  FileError where the output would replace what was read
void check_rays_stay(const CastOptions& options, const Scene& scene)
{
    std::vector<std::string> inputs = scene.files;
    const RayFiles& files = options.files;
    for (const std::string& input : {files.rays, files.origins, files.directions, files.skip})
        if (!input.empty()) inputs.push_back(input);
    check_inputs_stay(std::span(&options.output, 1), inputs);
}

/// Casts the rays, and writes what was asked for.
void cast(const CastOptions& options, RayCaster& caster, const World& world,
    const std::vector<Ray>& rays, CastReport& report)
{
    const std::vector<std::uint32_t>& owner = world.scene->owner;
    Stopwatch casting;
    const auto write = [&](const auto& to_file) {
        report.cast_ms = casting.ms();
        const Stopwatch writing;
        const HoldInterrupts hold;
        to_file();
        report.write_ms = writing.ms();
    };
    if (options.any) {
        std::vector<std::uint8_t> hit;
        caster.occluded(world, rays, hit);
        write([&] { write_any(options.output, hit); });
        for (const std::uint8_t one : hit) report.rays_that_hit += one;
        report.hits = report.rays_that_hit;
    } else if (options.count) {
        std::vector<std::uint32_t> count;
        caster.count(world, rays, count);
        write([&] { write_count(options.output, count); });
        for (const std::uint32_t of_ray : count) {
            report.hits += of_ray;
            report.rays_that_hit += of_ray > 0;
        }
    } else if (options.all) {
        RayHitLists lists;
        caster.all_hits(world, rays, lists);
        write([&] { write_all(options.output, lists, owner); });
        report.hits = lists.hit.size();
        for (std::size_t k = 0; k < rays.size(); ++k)
            report.rays_that_hit += lists.first[k + 1] > lists.first[k];
    } else {
        std::vector<RayHit> hits;
        caster.nearest(world, rays, hits);
        write([&] { write_nearest(options.output, hits, owner); });
        for (const RayHit& hit : hits) report.rays_that_hit += hit.triangle != kNoItem;
        report.hits = report.rays_that_hit;
    }
}

} // namespace

void add_cast_options(CLI::App& app, CastOptions& options)
{
    add_scene_options(app, options.scene);
    CLI::Option* rays = app.add_option("--rays", options.files.rays,
                               "A NumPy array of rays (N, 6), world space: origins and directions")
                            ->type_name("FILE.npy");
    CLI::Option* origins = app.add_option("--origins", options.files.origins,
                                  "A NumPy array of origins (N, 3), or (1, 3) for all rays")
                               ->type_name("FILE.npy");
    CLI::Option* directions = app.add_option("--directions", options.files.directions,
                                     "A NumPy array of directions (N, 3), or (1, 3) for all rays")
                                  ->type_name("FILE.npy");
    rays->excludes(origins)->excludes(directions);
    origins->needs(directions);
    directions->needs(origins);
    app.add_option("-o,--output", options.output, "What the rays hit: an archive of NumPy arrays")
        ->type_name("FILE.npz")
        ->required();
    CLI::Option* any =
        app.add_flag("--any", options.any, "Only whether each ray hits anything, which is faster");
    CLI::Option* all =
        app.add_flag("--all", options.all, "All hits of each ray, not only the nearest");
    CLI::Option* count =
        app.add_flag("--count", options.count, "Only how many triangles each ray hits");
    any->excludes(all)->excludes(count);
    all->excludes(count);
    app.add_option("--skip", options.files.skip,
           "A NumPy array (N,): a triangle that each ray does not hit")
        ->type_name("FILE.npy");
    add_parsed(app, "--tmin", options.files.t_min, parse_t, "T",
        "Hits nearer than this many lengths of the direction do not count; default 0, and the "
        "origin itself never counts");
    add_parsed(app, "--tmax", options.files.t_max, parse_t, "T",
        "Hits farther than this do not count; default inf");
    add_parsed(app, "--time", options.time_s, parse_number, "S",
        "Seconds; default the begin of the scene's animation");
    add_parsed(
        app, "--threads", options.threads,
        [](const std::string& text) { return parse_integer(text, 0, 1024); }, "N",
        "Threads, 0 to 1024; default 0: one for each core");
    CLI::Option* stats =
        app.add_flag("--stats", options.stats, "Print counts and times as a table");
    app.add_flag("--json", options.json, "Print them as one JSON object")->excludes(stats);
    app.footer(kCastExamples);
}

Json cast_json(const CastReport& report)
{
    return {
        {"rays", report.rays},
        {"triangles", report.triangles},
        {"rays_that_hit", report.rays_that_hit},
        {"hits", report.hits},
        {"threads", report.threads},
        {"instruction_set", report.instruction_set},
        {"load_ms", report.load_ms},
        {"pose_ms", report.pose_ms},
        {"build_ms", report.build_ms},
        {"cast_ms", report.cast_ms},
        {"write_ms", report.write_ms},
    };
}

std::string cast_text(const CastReport& report)
{
    std::string text;
    const auto count = [&](const char* name, std::uint64_t value) {
        text += fmt::format("{:<14} {:>14}\n", name, value);
    };
    const auto time = [&](const char* name, double ms) {
        text += fmt::format("{:<14} {:>11.2f} ms\n", name, ms);
    };
    count("rays", report.rays);
    count("triangles", report.triangles);
    count("rays that hit", report.rays_that_hit);
    count("hits", report.hits);
    time("load", report.load_ms);
    time("pose", report.pose_ms);
    time("build", report.build_ms);
    time("cast", report.cast_ms);
    time("write", report.write_ms);
    return text + fmt::format("{} threads, {}\n", report.threads, report.instruction_set);
}

int run_cast(const CastOptions& options)
{
    check(options);
    CastReport report;
    const Stopwatch loading;
    const std::vector<Ray> rays = read_rays(options.files);
    SceneSource source(options.scene);
    PoseSettings chosen = pose_settings(options.scene.pose, *source.first());
    chosen.time_s = options.time_s.value_or(chosen.time_s);
    const std::shared_ptr<const Scene> scene = source.scene_at(chosen.time_s);
    check_rays_stay(options, *scene);
    report.load_ms = loading.ms();

    const Stopwatch posing;
    World world;
    pose(scene, chosen, world);
    report.pose_ms = posing.ms();

    const Stopwatch building;
    RayCaster caster(options.threads);
    std::vector<std::uint8_t> none;
    caster.occluded(world, {}, none);
    report.build_ms = building.ms();
    cast(options, caster, world, rays, report);

    report.rays = rays.size();
    report.triangles = scene->triangle_count();
    report.threads = caster.threads();
    report.instruction_set = instruction_set();
    if (options.json) print(to_text(cast_json(report)));
    if (options.stats) print(cast_text(report));
    return kExitDone;
}

} // namespace firsthit::cli
