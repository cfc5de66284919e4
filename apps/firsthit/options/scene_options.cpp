// scene_options.cpp - which scene, and how its file is read.
#include "options/scene_options.h"

#include "inputs/standard_input.h"
#include "common/usage.h"
#include "common/add_parsed.h"
#include "common/parse.h"

#include <firsthit/sequence.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace firsthit::cli {

namespace {

constexpr double kRadians = 3.14159265358979323846 / 180;

double parse_crease_angle(const std::string& text)
{
    const double degrees = parse_number(text);
    if (0 <= degrees && degrees <= 180) return degrees * kRadians;
    throw UsageError(fmt::format("'{}' is no angle from 0 to 180 degrees", text));
}

double parse_fps(const std::string& text)
{
    const double fps = parse_number(text);
    if (SequenceSettings::kMinFps <= fps && fps <= SequenceSettings::kMaxFps) return fps;
    throw UsageError(fmt::format("'{}' is no number of frames a second from {} to {}", text,
        SequenceSettings::kMinFps, SequenceSettings::kMaxFps));
}

int parse_segments(const std::string& text)
{
    return parse_integer(text, LoadSettings::kMinSegments, LoadSettings::kMaxSegments);
}

std::string segments_help(const char* what)
{
    return fmt::format("Segments of {}, {} to {}; default 32", what, LoadSettings::kMinSegments,
        LoadSettings::kMaxSegments);
}

} // namespace

void add_scene_options(CLI::App& app, SceneOptions& options)
{
    app.add_option("SCENE", options.name,
           "A file (.gltf .glb .fbx .dae .3mf .aff .nff .ply .stl .obj .off), numbered files as "
           "frames/%04d.obj, "
           "builtin:torus, builtin:robots, builtin:room, builtin:wave?n=N, or - for standard input "
           "(with "
           "--format)")
        ->required();
    add_parsed(app, "--format", options.format, parse_scene_format, "KIND",
        "Of standard input: gltf, glb, fbx, dae, 3mf, aff, nff, ply, stl, obj or off");
    add_parsed(app, "--fps", options.fps, parse_fps, "N",
        "Of numbered files: by how much their numbers grow in a second. Of films and --frames by "
        "numbers: frames a second; default 24");
    app.add_option("--scene", options.load.scene,
           "Of a glTF file with several scenes: its name or number; default the file's own choice")
        ->type_name("NAME|N");
    add_pose_options(app, options.pose);
    add_parsed(app, "--crease-angle", options.load.crease_angle_rad, parse_crease_angle, "DEG",
        "Smooth the normals of files that have none across smaller angles; default 30");
    add_parsed(app, "--sphere-segments", options.load.sphere_segments, parse_segments, "N",
        segments_help("a sphere around its equator"));
    add_parsed(app, "--cone-segments", options.load.cone_segments, parse_segments, "N",
        segments_help("a cone around its axis"));
    app.add_flag("--strict", options.load.strict, "Warnings about the file are errors");
}

} // namespace firsthit::cli
