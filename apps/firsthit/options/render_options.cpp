// render_options.cpp - what `firsthit render` was asked for.
#include "options/render_options.h"

#include "films/film_writer.h"
#include "inputs/frame_pattern.h"
#include "common/add_parsed.h"
#include "common/usage.h"

#include <firsthit/error.h>
#include <firsthit/file.h>
#include <firsthit/film_data.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <set>

namespace firsthit::cli {

namespace {

constexpr const char* kExamples = R"(Examples:
  firsthit render builtin:torus -o torus.png
  firsthit render bunny.stl -o bunny.png --up-axis y --size 1920x1080 --aa 6
  firsthit render bunny.stl -o turn_%02d.png --up-axis y --turntable 36
  firsthit render bunny.stl --aov item=item.npy --aov depth=depth.exr --aov lit=lit.npy
  firsthit render builtin:robots --frames 0:10:251 -o robots_%04d.png --stats
  firsthit render builtin:robots -o spot.png --light spot:0,7,0,0,-1,0,90,60
  firsthit render builtin:robots -o quick.png --interleave 2
  firsthit render builtin:robots -o hybrid.png --engine hybrid --multisample exact --stats
  firsthit render builtin:torus -o sun.png --light directional:-1,-3,-1 --light point:0,4,0
  firsthit render helmet.glb -o helmet.png --environment hall.hdr --tonemap aces --samples 3
  firsthit render helmet.glb -o helmet.webp --background transparent --samples 4
  firsthit render - --format stl -o - <part.stl >part.png
  firsthit render walk.glb --frames 0:1:25 --aov motion=motion_%04d.exr
  firsthit render builtin:robots -o maps.png --shadows map --shadow-map-size 2048 --shadow-filter 3

Films are .mp4, .webm, .gif or .webp: frames by --frames or --turntable, or the whole animation.
Pictures are .png, .jpg, .webp (8 bit, sRGB) or .exr (float, linear); planes are .exr or .npy, and
depth and distance also .png: 16 bit, millimetres where the unit is the metre, 0 = none:
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
  instance          number of the mesh instance, uint32; none = 0xFFFFFFFF
  material          number of the material, uint32; none = 0xFFFFFFFF
  node              number of the node, uint32; none = 0xFFFFFFFF
  tangent           x, y, z: interpolated, unit, world space; w: side of the bitangent, 1 or -1
  metallic_roughness  metallic and roughness, textured, 0 to 1; other materials and none = 0
  emission          light of its own, textured, linear; other materials and none = 0
  motion            pixels right and down since the frame before, of what is seen; 0 in the first
  motion_visible    1 where it was visible in the frame before, else 0; 1 in the first
  normal_camera     as normal, in the camera's frame: x right, y down, z forward
  position_camera   in that frame, from the eye; z is the depth
Planes are of the ray through the pixel's centre, never blended. Row 0 is the top.

FIRSTHIT_ISA in the environment (AVX2, SSE4, ...) lowers the instruction set; results stay the same.
Exit codes: 0 done, 1 failed, 2 wrong usage, 3 nothing to do: --only or
--chunk leave no frame, or --resume finds the files of all that they leave.)";

int parse_tile_size(const std::string& text)
{
    const int size = parse_integer(text, 8, 128);
    if (size % 8 == 0) return size;
    throw UsageError(fmt::format("'{}' is no multiple of 8", text));
}

/// Every name has a place for a number where there are frames to number, and none otherwise.
void check_patterns(const RenderOptions& options)
{
    const std::vector<std::string> names = outputs(options);
    for (const std::string& name : names) {
        if (name == "-") continue; // one after the other
        if (is_film(options) && &name == &names.front()) continue;
        if (is_numbered(options))
            (void)FramePattern(name);
        else if (looks_like_pattern(name))
            throw UsageError(
                fmt::format("'{}' numbers frames: say which with --frames or --turntable", name));
    }
    if (is_film(options) && options.data.resume)
        throw UsageError("a film is made at once: --resume is of numbered pictures");
    if (is_film(options) && options.data.part.any())
        throw UsageError("a film is made at once: --only and --chunk are of numbered pictures");
    if (!is_numbered(options) && options.data.part.any())
        throw UsageError("--only and --chunk are of several frames: say which with --frames or "
                         "--turntable");
    if (!is_numbered(options) && options.data.resume)
        throw UsageError("--resume is of several frames: say which with --frames or --turntable");
    if (!options.data.manifest.empty() && looks_like_pattern(options.data.manifest))
        throw UsageError("--manifest: one file is of all frames: a name without a number");
}

/// Motion is counted in pixels of pictures of one size.
void check_motion(const RenderOptions& options)
{
    for (const AovOutput& aov : options.aovs) {
        if (aov.aov != Aov::motion && aov.aov != Aov::motion_visible) continue;
        const Size first = options.camera.pixels();
        for (std::size_t k = 1; k < options.camera.cameras.size(); ++k)
            if (options.camera.pixels(k).width != first.width ||
                options.camera.pixels(k).height != first.height)
                throw UsageError(
                    fmt::format("the plane '{}' needs pictures of one size, and the cameras of "
                                "the file have several: say --size",
                        aov_name(aov.aov)));
    }
}

/// Nothing but one picture or plane goes to standard output.
void check_standard_output(const RenderOptions& options)
{
    const std::vector<std::string> names = outputs(options);
    const bool taken = std::find(names.begin(), names.end(), "-") != names.end();
    if (taken && (options.stats || options.stats_json == "-"))
        throw UsageError(
            "standard output is taken by a picture or plane: send --stats to a file, by "
            "--stats-json FILE");
    if (!taken && !options.picture.format.empty())
        throw UsageError(
            "--output-format is of standard output, as with -o -; other files have endings");
}

/// No file is written twice.
void check_no_file_twice(const RenderOptions& options)
{
    std::vector<std::string> names = outputs(options);
    for (const std::string& name : {options.data.manifest, options.stats_json})
        if (!name.empty() && name != "-") names.push_back(name);
    std::set<std::string> seen;
    for (const std::string& name : names)
        if (!seen.insert(output_target(name)).second)
            throw UsageError(fmt::format("'{}' is to be written twice", name));
}

} // namespace

std::vector<std::string> outputs(const RenderOptions& options)
{
    std::vector<std::string> names;
    if (!options.output.empty()) names.push_back(options.output);
    for (const AovOutput& aov : options.aovs) names.push_back(aov.path);
    if (!options.data.exr.empty()) names.push_back(options.data.exr);
    return names;
}

bool is_film(const RenderOptions& options)
{
    return is_film_path(options.output, options.several());
}

bool is_numbered(const RenderOptions& options)
{
    return options.several() || is_film(options);
}

Frames frames_of(const RenderOptions& options, const Scene& scene, const PoseSettings& pose)
{
    FrameChoice choice = options.frames;
    if (is_film(options) && !options.several()) {
        choice.clip = true;
        if (!(scene.end_s(pose.clip) > scene.begin_s(pose.clip)))
            throw UsageError(
                fmt::format("{}: nothing moves in {}: say --turntable N to go round it",
                    options.output, options.scene.name));
    }
    return frames_of(options, choice, scene, pose);
}

void check_memory(const RenderOptions& options, std::size_t lights)
{
    // While one frame is made, another one is written.
    const std::uint64_t needed = film_bytes(options, lights) * (options.several() ? 2 : 1);
    const auto memory = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                        static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    if (needed <= memory) return;
    throw DeviceError(
        fmt::format("a film of {}x{} pixels takes {:.1f} GB, and this machine has {:.1f} "
                    "GB of memory: choose a smaller --size",
            options.camera.pixels().width, options.camera.pixels().height,
            static_cast<double>(needed) / 1e9, static_cast<double>(memory) / 1e9));
}

void add_render_options(CLI::App& app, RenderOptions& options)
{
    add_scene_options(app, options.scene);
    app.add_option("-o,--output", options.output,
           "The picture: .png, .jpg, .webp (8 bit, sRGB) or .exr (float, linear); - is standard "
           "output")
        ->type_name("FILE");
    app.add_option_function<std::vector<std::string>>(
           "--aov",
           [&options](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) options.aovs.push_back(parse_aov(text));
           },
           "A plane and its file, .exr or .npy, of depth and distance also .png; may be repeated")
        ->type_name("NAME=FILE")
        ->allow_extra_args(false);
    const auto integer = [](int low, int high) {
        return [low, high](const std::string& text) { return parse_integer(text, low, high); };
    };
    add_picture_set_options(app, options);
    add_data_options(app, options.data);
    add_light_options(app, options.light);
    add_sky_options(app, options.sky);
    add_ground_option(app, options.ground);
    add_environment_options(app, options.environment);
    add_picture_options(app, options.picture);
    add_parsed(app, "--samples", options.samples, integer(1, 16), "N",
        "N x N rays in every pixel, 1 to 16; default: see --aa");
    add_parsed(app, "--aa", options.adaptive, integer(1, 16), "N",
        "N x N rays where a pixel may hold an edge, the border of a shadow or contrast, and one "
        "ray "
        "elsewhere, 1 to 16; default 4 for a picture, 1: nowhere. Not for the gpu engine");
    add_parsed(app, "--engine", options.engine.engine, parse_engine, "cpu|hybrid|gpu|auto",
        "Who makes the picture: cpu, exactly; hybrid, items and shadow maps by OpenGL and rays by "
        "the CPU; gpu, all by OpenGL; auto, gpu where OpenGL runs on hardware; default cpu");
    add_engine_options(app, options.engine);
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
    const bool data = !options.data.exr.empty() || !options.data.manifest.empty();
    if (options.output.empty() && options.aovs.empty() && !measured && !data)
        throw UsageError("nothing is asked for: say -o FILE, --aov NAME=FILE or --stats");
    check(options.light, options.engine.engine);
    check(options.sky, !options.light.lights.empty());
    if (options.ground.wanted && options.picture.backdrop.transparent)
        throw UsageError("--ground is a surface, --background transparent shows none: say one");
    if (options.engine.engine == Engine::gpu && options.light.shadows == Shadows::exact)
        throw UsageError("--engine gpu has shadow maps only: accepted are --shadows map and none");
    if (options.adaptive && options.samples)
        throw UsageError("--samples shoots its rays in every pixel, --aa where there are edges: "
                         "say one");
    if (options.engine.interleave > 1 && options.adaptive.value_or(1) > 1)
        throw UsageError("--interleave shoots less than a ray a pixel, --aa more: say one");
    if (options.engine.engine == Engine::gpu && options.adaptive.value_or(1) > 1)
        throw UsageError("--engine gpu has no --aa: accepted is --samples N");
    if (options.engine.interleave > 1 && options.samples.value_or(1) > 1)
        throw UsageError("--interleave shoots less than a ray a pixel, --samples more: say one");
    check_patterns(options);
    check_motion(options);
    const Backdrop& backdrop = options.picture.backdrop;
    if (options.environment.background.value_or(false) &&
        (backdrop.color || backdrop.needs_alpha()))
        throw UsageError(
            "--environment-background on and --background both say what is behind: say one");
    check_standard_output(options);
    check_no_file_twice(options);
    if (is_film(options) && (options.picture.backdrop.transparent || options.picture.quality))
        throw UsageError("--background transparent and --quality are of pictures, not of films");
    if (!options.output.empty() && !is_film(options))
        check_picture(options.picture, file_name(options, options.output, 0));
    else if (options.output.empty() &&
             (options.picture.backdrop.needs_alpha() || options.picture.quality))
        throw UsageError("--background and --quality are of a picture: say -o FILE too");
    try {
        if (is_film(options)) check_film(options.output);
        if (!options.data.exr.empty()) check_planes_path(file_name(options, options.data.exr, 0));
        for (const AovOutput& aov : options.aovs)
            check_plane_path(
                aov.aov, file_name(options, aov.path, 0), plane_format(options.picture, aov.path));
    } catch (const ArgumentError& error) {
        throw UsageError(error.what());
    }
    if (!options.data.manifest.empty()) check_output_path(options.data.manifest);
    if (!options.stats_json.empty() && options.stats_json != "-")
        check_output_path(options.stats_json);
    check_memory(options, options.light.lights.size());
}

std::string file_name(const RenderOptions& options, const std::string& text, int frame)
{
    if (text == "-" || (is_film(options) && text == options.output)) return text;
    return is_numbered(options) ? FramePattern(text).name(frame) : text;
}

void check_inputs_stay(const RenderOptions& options, const Scene& scene)
{
    const Frames frames = frames_of(options, scene, pose_settings(options.scene.pose, scene));
    std::vector<std::string> names;
    for (const std::string& name : outputs(options))
        for (const int number : frames.number) names.push_back(file_name(options, name, number));
    for (const std::string& name : {options.data.manifest, options.stats_json})
        if (!name.empty() && name != "-") names.push_back(name);
    check_output_replaces_nothing(options, scene, names);
}

int adaptive_samples(const RenderOptions& options)
{
    const bool picture = !options.output.empty() && !options.samples &&
                         options.engine.interleave == 1 && options.engine.engine != Engine::gpu;
    return options.adaptive.value_or(picture && !options.sky.draft ? 4 : 1);
}

std::function<void(Scene&)> scene_changes(const RenderOptions& options)
{
    return [light = options.light, environment = options.environment, sky = options.sky,
               backdrop = options.picture.backdrop](Scene& scene) {
        apply(light, scene);
        apply(environment, scene);
        if (wants_studio(sky, scene, !light.lights.empty())) apply_studio(sky, scene);
        apply(backdrop, scene);
    };
}

Settings render_settings(const RenderOptions& options)
{
    Settings settings;
    settings.samples = options.samples.value_or(1);
    settings.adaptive = adaptive_samples(options);
    const PlaneChoice in_exr = options.data.planes.value_or(PlaneChoice());
    const bool exr = !options.data.exr.empty();
    settings.color = !options.output.empty() || (exr ? in_exr.color : options.aovs.empty());
    settings.alpha = settings.color && options.picture.backdrop.needs_alpha();
    apply(options.engine, settings);
    settings.tile_size = options.tile_size;
    for (const AovOutput& aov : options.aovs) settings.aovs.push_back(aov.aov);
    if (exr) settings.aovs.insert(settings.aovs.end(), in_exr.aovs.begin(), in_exr.aovs.end());
    apply(options.light, settings);
    return settings;
}

std::uint64_t film_bytes(const RenderOptions& options, std::size_t lights)
{
    const Settings settings = render_settings(options);
    std::set<Aov> planes(settings.aovs.begin(), settings.aovs.end());
    std::uint64_t channels = (settings.color ? 3 : 0) + (settings.alpha ? 1 : 0);
    for (const Aov aov : planes)
        channels += aov == Aov::lit ? std::min(lights, kMaxLitLights)
                                    : static_cast<std::uint64_t>(aov_channels(aov));
    const Region& region = options.camera.region;
    const Size whole = options.camera.pixels();
    return 4 * channels *
           static_cast<std::uint64_t>(region.width > 0 ? region.width : whole.width) *
           static_cast<std::uint64_t>(region.height > 0 ? region.height : whole.height);
}

} // namespace firsthit::cli
