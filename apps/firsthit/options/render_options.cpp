// render_options.cpp - what `firsthit render` was asked for.
#include "options/render_options.h"

#include "options/frame_pattern.h"
#include "common/usage.h"

#include <firsthit/error.h>
#include <firsthit/file.h>

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <set>

namespace firsthit::cli {

namespace {

constexpr const char* kExamples = R"(Examples:
  firsthit render builtin:torus -o torus.png
  firsthit render bunny.stl -o bunny.png --eye 0,0.12,0.3 --size 1920x1080 --samples 2
  firsthit render bunny.stl --aov item=item.npy --aov depth=depth.exr --aov lit=lit.npy
  firsthit render builtin:robots --frames 0:10:251 -o robots_%04d.png --stats
  firsthit render builtin:robots -o spot.png --light spot:0,7,0,0,-1,0,90,60
  firsthit render builtin:robots -o quick.png --interleave 2
  firsthit render builtin:robots -o hybrid.png --engine hybrid --multisample exact --stats
  firsthit render builtin:torus -o sun.png --light directional:-1,-3,-1 --light point:0,4,0
  firsthit render builtin:robots -o maps.png --shadows map --shadow-map-size 2048 --shadow-filter 3

Pictures are .png (8 bit, sRGB) or .exr (float, linear); planes are .exr or .npy:
  item              triangle id, uint32; none = 0xFFFFFFFF
  depth             along the view axis, world units; none = inf
  distance          from the eye, world units; none = inf
  uv                texture coordinates
  normal            interpolated, unit, world space, towards the eye
  geometric_normal  of the triangle's plane, unit, world space, towards the eye
  position          world space
  albedo            diffuse colour times texture, linear
  barycentric       u, v: weights of the triangle's corners 1 and 2
  lit               a channel for each light: the share that shadows leave, 0 to 1; none = 0
Planes are of the ray through the pixel's centre, never blended. Row 0 is the top.

FIRSTHIT_ISA in the environment (AVX2, SSE4, ...) lowers the instruction set; results stay the same.
Exit codes: 0 done, 1 failed, 2 wrong usage.)";

int parse_tile_size(const std::string& text)
{
    const int size = parse_integer(text, 8, 128);
    if (size % 8 == 0) return size;
    throw UsageError(fmt::format("'{}' is no multiple of 8", text));
}

/// The planes' files and the picture's, as they were typed.
std::vector<std::string> outputs(const RenderOptions& options)
{
    std::vector<std::string> names;
    if (!options.output.empty()) names.push_back(options.output);
    for (const AovOutput& aov : options.aovs) names.push_back(aov.path);
    return names;
}

/// Every name has a place for a number where there are frames to number, and none otherwise.
void check_patterns(const RenderOptions& options)
{
    for (const std::string& name : outputs(options)) {
        if (!options.frames.empty())
            (void)FramePattern(name);
        else if (looks_like_pattern(name))
            throw UsageError(fmt::format("'{}' numbers frames: say which with --frames", name));
    }
}

/// No file is written twice.
void check_no_file_twice(const RenderOptions& options)
{
    std::vector<std::string> names = outputs(options);
    if (!options.stats_json.empty() && options.stats_json != "-")
        names.push_back(options.stats_json);
    std::set<std::string> seen;
    for (const std::string& name : names)
        if (!seen.insert(output_target(name)).second)
            throw UsageError(fmt::format("'{}' is to be written twice", name));
}

} // namespace

void check_memory(const RenderOptions& options, std::size_t lights)
{
    const std::uint64_t needed = film_bytes(options, lights);
    const auto memory = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                        static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    if (needed <= memory) return;
    throw DeviceError(
        fmt::format("a film of {}x{} pixels takes {:.1f} GB, and this machine has {:.1f} "
                    "GB of memory: choose a smaller --size",
            options.camera.size.width, options.camera.size.height,
            static_cast<double>(needed) / 1e9, static_cast<double>(memory) / 1e9));
}

void add_render_options(CLI::App& app, RenderOptions& options)
{
    add_scene_options(app, options.scene);
    app.add_option(
           "-o,--output", options.output, "The picture: .png (8 bit, sRGB) or .exr (float, linear)")
        ->type_name("FILE");
    app.add_option_function<std::vector<std::string>>(
           "--aov",
           [&options](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) options.aovs.push_back(parse_aov(text));
           },
           "A plane and its file, .exr or .npy; may be repeated")
        ->type_name("NAME=FILE")
        ->allow_extra_args(false);
    CLI::Option* time = add_parsed(app, "--time", options.time_s, parse_number, "S",
        "Seconds; default the begin of the scene's animation");
    add_parsed(app, "--frames", options.frames, parse_frames, "A:B:N",
        "N frames from time A to time B, both included. Files need one %d, %4d or %04d, "
        "numbered from 0")
        ->excludes(time);
    add_camera_options(app, options.camera);
    add_light_options(app, options.light);
    const auto integer = [](int low, int high) {
        return [low, high](const std::string& text) { return parse_integer(text, low, high); };
    };
    add_parsed(app, "--samples", options.samples, integer(1, 16), "N",
        "N x N rays a pixel, 1 to 16; default 1");
    add_parsed(app, "--engine", options.engine.engine, parse_engine, "cpu|hybrid|gpu|auto",
        "Who makes the picture: cpu, exactly; hybrid, items and shadow maps by OpenGL and rays by "
        "the CPU; gpu, all by OpenGL; auto, gpu where OpenGL runs on hardware; default cpu");
    add_engine_options(app, options.engine);
    add_parsed(app, "--threads", options.threads, integer(0, 1024), "N",
        "Threads, 0 to 1024; default 0: one for each core");
    add_parsed(app, "--tile-size", options.tile_size, parse_tile_size, "N",
        "Pixels on a tile's side, a multiple of 8 from 8 to 128; default 64");
    app.add_flag("--stats", options.stats, "Print milliseconds by stage and counts");
    app.add_option("--stats-json", options.stats_json, "Write them as JSON; - is standard output")
        ->type_name("FILE");
    app.footer(kExamples);
}

void check(const RenderOptions& options)
{
    const bool measured = options.stats || !options.stats_json.empty();
    if (options.output.empty() && options.aovs.empty() && !measured)
        throw UsageError("nothing is asked for: say -o FILE, --aov NAME=FILE or --stats");
    check(options.light, options.engine.engine);
    if (options.engine.engine == Engine::gpu && options.light.shadows == Shadows::exact)
        throw UsageError("--engine gpu has shadow maps only: accepted are --shadows map and none");
    if (options.engine.interleave > 1 && options.samples > 1)
        throw UsageError("--interleave shoots less than a ray a pixel, --samples more: say one");
    check_patterns(options);
    check_no_file_twice(options);
    try {
        if (!options.output.empty()) check_color_path(file_name(options, options.output, 0));
        for (const AovOutput& aov : options.aovs) check_aov_path(file_name(options, aov.path, 0));
    } catch (const ArgumentError& error) {
        throw UsageError(error.what());
    }
    if (!options.stats_json.empty() && options.stats_json != "-")
        check_output_path(options.stats_json);
    check_memory(options, options.light.lights.size());
}

std::string file_name(const RenderOptions& options, const std::string& text, int frame)
{
    return options.frames.empty() ? text : FramePattern(text).name(frame);
}

void check_inputs_stay(const RenderOptions& options, const Scene& scene)
{
    if (scene.files.empty()) return;
    const std::size_t frames = std::max<std::size_t>(1, options.frames.size());
    std::vector<std::string> names;
    for (const std::string& name : outputs(options))
        for (std::size_t frame = 0; frame < frames; ++frame)
            names.push_back(file_name(options, name, static_cast<int>(frame)));
    if (!options.stats_json.empty() && options.stats_json != "-")
        names.push_back(options.stats_json);
    firsthit::check_inputs_stay(names, scene.files);
}

Settings render_settings(const RenderOptions& options)
{
    Settings settings;
    settings.samples = options.samples;
    settings.color = !options.output.empty() || options.aovs.empty();
    apply(options.engine, settings);
    settings.tile_size = options.tile_size;
    for (const AovOutput& aov : options.aovs) settings.aovs.push_back(aov.aov);
    apply(options.light, settings);
    return settings;
}

std::uint64_t film_bytes(const RenderOptions& options, std::size_t lights)
{
    const Settings settings = render_settings(options);
    std::set<Aov> planes(settings.aovs.begin(), settings.aovs.end());
    std::uint64_t channels = settings.color ? 3 : 0;
    for (const Aov aov : planes)
        channels += aov == Aov::lit ? std::min(lights, kMaxLitLights)
                                    : static_cast<std::uint64_t>(aov_channels(aov));
    return 4 * channels * static_cast<std::uint64_t>(options.camera.size.width) *
           static_cast<std::uint64_t>(options.camera.size.height);
}

} // namespace firsthit::cli
