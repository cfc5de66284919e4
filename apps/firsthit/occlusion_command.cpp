// occlusion_command.cpp - `firsthit occlusion`: which points do lights not reach?
#include "occlusion_command.h"

#include "common/add_parsed.h"
#include "common/interrupt.h"
#include "occlusion_tables.h"
#include "options/camera_options.h"
#include "options/light_options.h"
#include "common/output.h"
#include "inputs/scene_source.h"
#include "common/parse.h"
#include "common/progress.h"
#include "common/stopwatch.h"
#include "common/usage.h"

#include <firsthit/error.h>
#include <firsthit/file.h>
#include <firsthit/npy.h>
#include <firsthit/occlusion.h>
#include <firsthit/render.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>

namespace firsthit::cli {

namespace {

constexpr const char* kOcclusionExamples = R"(Examples:
  python3 -c 'import numpy; numpy.save("points.npy", [[-1.2, 0.6, 0.6], [-1.3, 0.6, -1]])'
  firsthit occlusion builtin:robots --points points.npy --direction -1,-2,0.5 -o shade.npy
  firsthit occlusion builtin:robots --points points.npy --light 9,16,7 --time 3 --json -o dark.npy
  firsthit occlusion bunny.stl --points points.npy --directions sky.npy --packed -o sky_bits.npy
  firsthit occlusion town.obj --points points.npy --hours -o hours.csv \
      --sun 52.5,13.4,2026-06-21T00:00+02:00,2026-06-22T00:00+02:00,15m

Points are float32 or float64 (N, 3), rounded to float32: subtract what is large from scene and
points before. Directions are the way the light travels, float32 or float64 (L, 3). The output is
uint8, 1 where a triangle stands between the point and the light:
  one --direction or --light     (N,)
  several, or --directions       (L, N), in the order given
  --hours                        float32 (N,): hours of sun; L suns are (L, N), 1 in the night
  --packed                       (L, ceil(N / 8)): bit k of byte j, of value 2^k, is point 8 j + k
                                 (numpy.unpackbits(a, axis=1, count=N, bitorder='little'))
Points outside a spot's cone are occluded; points that are not finite never are. --receivers names
the triangle that each point lies on, which does not occlude it: uint32, int32, uint64 or int64
(N,), -1 or 4294967295 for none. Exit codes: 0 done, 1 failed, 2 wrong usage.)";

Light parse_point_or_light(const std::string& text)
{
    if (text.find(':') != std::string::npos) return parse_light(text);
    Light light;
    light.position = parse_vector(text);
    return light;
}

Light directional_light(const glm::dvec3& direction)
{
    Light light;
    light.kind = Light::Kind::directional;
    light.direction = direction;
    return light;
}

/// Whether it can be normalised.
bool has_length(const glm::dvec3& v)
{
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && 1e-100 <= largest &&
           largest <= 1e100;
}

double parse_north(const std::string& text)
{
    const double degrees = parse_number(text);
    if (-360 <= degrees && degrees <= 360) return degrees;
    throw UsageError(fmt::format("'{}' is no angle from -360 to 360 degrees", text));
}

/// Sets the bits of the rows that no light has: in the night the sun reaches nothing.
void fill_nights(
    const std::vector<std::size_t>& rows, std::size_t points, std::vector<std::uint8_t>& bits)
{
    const std::size_t bytes = (points + 7) / 8;
    const std::vector<std::uint8_t> all(points, 1);
    std::size_t next = 0;
    for (std::size_t row = 0; row * bytes < bits.size(); ++row) {
        if (next < rows.size() && rows[next] == row)
            ++next;
        else
            pack_bits(all, std::span(bits).subspan(row * bytes, bytes));
    }
}

Light parse_direction(const std::string& text)
{
    const glm::dvec3 direction = parse_vector(text);
    if (!has_length(direction))
        throw UsageError(
            fmt::format("'{}' is no direction: accepted is a length from 1e-100 to 1e100", text));
    return directional_light(direction);
}

template <class Parse>
CLI::Option* add_lights(CLI::App& app, const std::string& name, std::vector<Light>& lights,
    Parse parse, const std::string& type, const std::string& help)
{
    const auto store = [&lights, parse, name](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) {
            try {
                lights.push_back(parse(text));
            } catch (const UsageError& error) {
                throw UsageError(name + ": " + error.what());
            }
        }
    };
    return app.add_option_function<std::vector<std::string>>(name, store, help)
        ->type_name(type)
        ->allow_extra_args(false);
}

void check(const OcclusionOptions& options)
{
    if (options.lights.empty() && options.directions.empty() && !options.sun)
        throw UsageError("no light: say which with --direction, --directions, --light or --sun");
    const std::string ending = std::filesystem::path(options.output).extension().string();
    if (ending != ".npy" && ending != ".csv")
        throw UsageError(fmt::format("'{}': accepted are .npy and .csv", options.output));
    if (options.hours && !options.sun) throw UsageError("--hours is of --sun: say it too");
    if (options.packed && (options.hours || ending == ".csv"))
        throw UsageError("--packed is of answers in .npy");
    for (const Light& light : options.lights)
        if (light.on_camera) throw UsageError("a light on the camera: there is no camera here");
    check_output_path(options.output);
}

/// throws  FileError where the output would replace what was read
void check_inputs_stay(const OcclusionOptions& options, const Scene& scene)
{
    std::vector<std::string> inputs = {options.points};
    for (const std::string& input : {options.directions, options.receivers})
        if (!input.empty()) inputs.push_back(input);
    inputs.insert(inputs.end(), scene.files.begin(), scene.files.end());
    firsthit::check_inputs_stay(std::span(&options.output, 1), inputs);
}

/// What --light, --direction, --directions or --sun ask for.
struct AskedLights {
    std::vector<Light> lights;    // that shine
    std::vector<std::size_t> row; // of each, among all that were asked for
    std::vector<double> hours;    // (rows) of --sun
    std::size_t rows = 0;         // with suns below the horizon
};

std::vector<Light> lights_of(const OcclusionOptions& options)
{
    if (options.directions.empty()) {
        const glm::dvec3 up = options.up_axis.value_or(usual_up_axis(options.scene.shown_name()));
        std::vector<Light> lights = options.lights;
        for (const std::size_t k : options.suns)
            lights[k].direction = turned_up(lights[k].direction, up);
        return lights;
    }
    std::vector<Light> lights;
    for (const glm::dvec3& direction : read_npy_vectors(options.directions)) {
        if (!has_length(direction))
            throw FileError(fmt::format("{}: row {}: ({}, {}, {}) is no direction: accepted is a "
                                        "length from 1e-100 to 1e100",
                options.directions, lights.size(), direction.x, direction.y, direction.z));
        lights.push_back(directional_light(direction));
    }
    return lights;
}

AskedLights asked_lights(const OcclusionOptions& options)
{
    AskedLights asked;
    if (!options.sun) {
        asked.lights = lights_of(options);
        for (std::size_t k = 0; k < asked.lights.size(); ++k) asked.row.push_back(k);
        asked.rows = asked.lights.size();
        return asked;
    }
    const glm::dvec3 up = options.up_axis.value_or(usual_up_axis(options.scene.shown_name()));
    for (const SunStep& step : sun_steps(*options.sun, options.north_deg)) {
        if (step.direction) {
            asked.lights.push_back(directional_light(turned_up(*step.direction, up)));
            asked.row.push_back(asked.rows);
        }
        asked.hours.push_back(step.hours);
        ++asked.rows;
    }
    return asked;
}

/// Bits of all lights, (L, ceil(N / 8)), as a file of the shape that was asked for.
void write(const OcclusionOptions& options, const std::vector<std::uint8_t>& bits,
    std::size_t lights, std::size_t points)
{
    const std::size_t bytes = (points + 7) / 8;
    NpyShape shape{.rows = lights, .columns = points};
    if (options.packed) shape.columns = bytes;
    shape.one_dimension =
        !options.packed && options.directions.empty() && !options.sun && lights == 1;
    write_npy_bytes(options.output, shape, [&](std::size_t light, std::span<std::uint8_t> values) {
        const std::uint8_t* row = bits.data() + light * bytes;
        for (std::size_t k = 0; k < values.size(); ++k)
            values[k] = options.packed ? row[k] : row[k / 8] >> (k % 8) & 1;
    });
}

} // namespace

void add_occlusion_options(CLI::App& app, OcclusionOptions& options)
{
    add_scene_options(app, options.scene);
    app.add_option("--points", options.points, "A NumPy array of points (N, 3), world space")
        ->type_name("FILE.npy")
        ->required();
    CLI::Option* direction = add_lights(app, "--direction", options.lights, parse_direction,
        "x,y,z", "The way parallel light travels, any length; may be repeated");
    CLI::Option* directions = app.add_option("--directions", options.directions,
                                     "A NumPy array of such directions (L, 3)")
                                  ->type_name("FILE.npy");
    const auto point_or_light = [&options](const std::string& text) {
        if (is_sun(text)) options.suns.push_back(options.lights.size());
        return parse_point_or_light(text);
    };
    CLI::Option* light = add_lights(app, "--light", options.lights, point_or_light, "x,y,z",
        "Where a light is, or a light as `firsthit render --light` takes it; may be repeated");
    direction->excludes(directions)->excludes(light);
    light->excludes(directions);
    CLI::Option* sun = add_parsed(app, "--sun", options.sun, parse_sun_span, "LAT,LON,FROM,TO,STEP",
        "The sun over a span of time, in the middle of each step: times in ISO 8601 with their "
        "zones, "
        "steps as 15m; east is x, and north -z where y is up, y where z is");
    sun->excludes(directions)->excludes(light)->excludes(direction);
    app.add_flag(
        "--hours", options.hours, "Of --sun: write how many hours the sun reaches each point");
    add_parsed(app, "--north", options.north_deg, parse_north, "DEG",
        "Of --sun: where north is, clockwise from above; default 0")
        ->needs(sun);
    add_parsed(app, "--up-axis", options.up_axis, parse_axis, "AXIS",
        "Of suns, what is up: x, y, z, -x, -y or -z; default z for .stl, .ply and .3mf, else y");
    app.add_option("--receivers", options.receivers,
           "A NumPy array (N,): the triangle that each point lies on")
        ->type_name("FILE.npy");
    app.add_option("-o,--output", options.output,
           "The answers: 1 occluded, 0 not, or hours; .npy, or .csv with a row for each point")
        ->type_name("FILE")
        ->required();
    app.add_flag("--packed", options.packed, "Write bits, eight points a byte");
    add_parsed(app, "--time", options.time_s, parse_number, "S",
        "Seconds; default the begin of the scene's animation");
    add_parsed(
        app, "--threads", options.threads,
        [](const std::string& text) { return parse_integer(text, 0, 1024); }, "N",
        "Threads, 0 to 1024; default 0: one for each core");
    CLI::Option* stats =
        app.add_flag("--stats", options.stats, "Print counts and times as a table");
    app.add_flag("--json", options.json, "Print them as one JSON object")->excludes(stats);
    app.footer(kOcclusionExamples);
}

Json occlusion_json(const OcclusionReport& report)
{
    return {
        {"points", report.points},
        {"lights", report.lights},
        {"triangles", report.triangles},
        {"occluded", report.occluded},
        {"nights", report.nights},
        {"threads", report.threads},
        {"instruction_set", report.instruction_set},
        {"load_ms", report.load_ms},
        {"pose_ms", report.pose_ms},
        {"test_ms", report.test_ms},
        {"write_ms", report.write_ms},
    };
}

std::string occlusion_text(const OcclusionReport& report)
{
    std::string text;
    const auto count = [&](const char* name, std::uint64_t value) {
        text += fmt::format("{:<10} {:>14}\n", name, value);
    };
    const auto time = [&](const char* name, double ms) {
        text += fmt::format("{:<10} {:>11.2f} ms\n", name, ms);
    };
    count("points", report.points);
    count("lights", report.lights);
    count("triangles", report.triangles);
    count("occluded", report.occluded);
    time("load", report.load_ms);
    time("pose", report.pose_ms);
    time("test", report.test_ms);
    time("write", report.write_ms);
    return text + fmt::format("{} threads, {}\n", report.threads, report.instruction_set);
}

int run_occlusion(const OcclusionOptions& options)
{
    check(options);
    OcclusionReport report;
    const Stopwatch loading;
    const std::vector<glm::vec3> points = read_npy_points(options.points);
    std::vector<std::uint32_t> receivers;
    if (!options.receivers.empty()) {
        receivers = read_npy_ids(options.receivers);
        if (receivers.size() != points.size())
            throw ArgumentError(fmt::format("{}: {} receivers for the {} points of {}",
                options.receivers, receivers.size(), points.size(), options.points));
    }
    const AskedLights asked = asked_lights(options);
    const std::vector<Light>& lights = asked.lights;
    SceneSource source(options.scene);
    PoseSettings chosen = pose_settings(options.scene.pose, *source.first());
    chosen.time_s = options.time_s.value_or(chosen.time_s);
    const std::shared_ptr<const Scene> scene = source.scene_at(chosen.time_s);
    check_inputs_stay(options, *scene);
    report.load_ms = loading.ms();

    const Stopwatch posing;
    World world;
    pose(scene, chosen, world);
    report.pose_ms = posing.ms();

    // Bits: a million points and 145 directions are 18 MB, whatever is written.
    const Stopwatch testing;
    const std::size_t bytes = (points.size() + 7) / 8;
    std::vector<std::uint8_t> bits;
    std::vector<double> hours;
    if (options.hours) {
        hours.resize(points.size());
    } else {
        bits.assign(asked.rows * bytes, 0);
        if (asked.rows > lights.size()) fill_nights(asked.row, points.size(), bits);
    }
    Occlusion occlusion(options.threads);
    {
        Progress progress("lights", std::max<std::size_t>(1, lights.size()));
        const auto keep = [&](std::size_t light, std::span<const std::uint8_t> occluded) {
            const std::size_t row = asked.row[light];
            if (options.hours) {
                for (std::size_t k = 0; k < hours.size(); ++k)
                    if (!occluded[k]) hours[k] += asked.hours[row];
                report.occluded += std::uint64_t(std::count(occluded.begin(), occluded.end(), 1));
            } else {
                pack_bits(occluded, std::span(bits).subspan(row * bytes, bytes));
            }
            progress.advance();
        };
        occlusion.test(world, points, lights, keep, receivers);
    }
    report.test_ms = testing.ms();

    const Stopwatch writing;
    {
        const HoldInterrupts hold;
        const bool table = std::filesystem::path(options.output).extension() == ".csv";
        if (options.hours && table)
            write_hours_csv(options.output, points, hours);
        else if (options.hours)
            write_npy_floats(options.output, std::vector<float>(hours.begin(), hours.end()));
        else if (table)
            write_answers_csv(options.output, points, bits, asked.rows);
        else
            write(options, bits, asked.rows, points.size());
    }
    report.write_ms = writing.ms();
    report.points = points.size();
    report.lights = asked.rows;
    report.nights = asked.rows - lights.size();
    if (options.hours)
        report.occluded += report.nights * points.size(); // as the rows of the night say
    report.triangles = scene->triangle_count();
    for (const std::uint8_t byte : bits) report.occluded += std::uint64_t(std::popcount(byte));
    report.threads = occlusion.threads();
    report.instruction_set = instruction_set();
    if (options.json) print(to_text(occlusion_json(report)));
    if (options.stats) print(occlusion_text(report));
    return kExitDone;
}

} // namespace firsthit::cli
