// scene_options.cpp - which scene, and how its file is read.
#include "options/scene_options.h"

#include "common/output.h"
#include "common/parse.h"

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
           "A file (.aff .nff .ply .stl .obj), builtin:torus, builtin:robots or builtin:wave?n=N")
        ->required();
    add_parsed(app, "--crease-angle", options.load.crease_angle_rad, parse_crease_angle, "DEG",
        "Smooth the normals of files that have none across smaller angles; default 180");
    add_parsed(app, "--sphere-segments", options.load.sphere_segments, parse_segments, "N",
        segments_help("a sphere around its equator"));
    add_parsed(app, "--cone-segments", options.load.cone_segments, parse_segments, "N",
        segments_help("a cone around its axis"));
}

Scene load(const SceneOptions& options)
{
    Scene scene = load_scene(options.name, options.load);
    print_warnings(scene.warnings);
    return scene;
}

} // namespace firsthit::cli
