// occlusion_command.cpp - `firsthit occlusion`: which points do lights not reach?
#include "occlusion_command.h"

#include "common/interrupt.h"
#include "options/light_options.h"
#include "common/output.h"
#include "common/parse.h"
#include "common/progress.h"
#include "common/stopwatch.h"
#include "common/usage.h"

#include <firsthit/error.h>
#include <firsthit/file.h>
#include <firsthit/npy.h>
#include <firsthit/occlusion.h>
#include <firsthit/render.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>

namespace firsthit::cli {

namespace {

constexpr const char* kExamples = R"(Examples:
  python3 -c 'import numpy; numpy.save("points.npy", [[-1.2, 0.6, 0.6], [-1.3, 0.6, -1]])'
  firsthit occlusion builtin:robots --points points.npy --direction -1,-2,0.5 -o shade.npy
  firsthit occlusion builtin:robots --points points.npy --light 9,16,7 --time 3 --json -o dark.npy
  firsthit occlusion bunny.stl --points points.npy --directions sky.npy --packed -o sky_bits.npy

Points are float32 or float64 (N, 3), rounded to float32: subtract what is large from scene and
points before. Directions are the way the light travels, float32 or float64 (L, 3). The output is
uint8, 1 where a triangle stands between the point and the light:
  one --direction or --light     (N,)
  several, or --directions       (L, N), in the order given
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
    if (options.lights.empty() && options.directions.empty())
        throw UsageError("no light: say which with --direction, --directions or --light");
    if (std::filesystem::path(options.output).extension() != ".npy")
        throw UsageError(fmt::format("'{}': accepted is .npy", options.output));
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

std::vector<Light> lights_of(const OcclusionOptions& options)
{
    if (options.directions.empty()) return options.lights;
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

/// Bits of all lights, (L, ceil(N / 8)), as a file of the shape that was asked for.
void write(const OcclusionOptions& options, const std::vector<std::uint8_t>& bits,
    std::size_t lights, std::size_t points)
{
    const std::size_t bytes = (points + 7) / 8;
    NpyShape shape{.rows = lights, .columns = points};
    if (options.packed) shape.columns = bytes;
    shape.one_dimension = !options.packed && options.directions.empty() && lights == 1;
    const HoldInterrupts hold;
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
    CLI::Option* light = add_lights(app, "--light", options.lights, parse_point_or_light, "x,y,z",
        "Where a light is, or a light as `firsthit render --light` takes it; may be repeated");
    direction->excludes(directions)->excludes(light);
    light->excludes(directions);
    app.add_option("--receivers", options.receivers,
           "A NumPy array (N,): the triangle that each point lies on")
        ->type_name("FILE.npy");
    app.add_option("-o,--output", options.output, "The answers: 1 occluded, 0 not")
        ->type_name("FILE.npy")
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
    app.footer(kExamples);
}

Json occlusion_json(const OcclusionReport& report)
{
    return {
        {"points", report.points},
        {"lights", report.lights},
        {"triangles", report.triangles},
        {"occluded", report.occluded},
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
    const std::vector<Light> lights = lights_of(options);
    const auto scene = std::make_shared<const Scene>(load(options.scene));
    check_inputs_stay(options, *scene);
    report.load_ms = loading.ms();

    const Stopwatch posing;
    World world;
    pose(scene, options.time_s.value_or(scene->begin_s), world);
    report.pose_ms = posing.ms();

    // Bits: a million points and 145 directions are 18 MB, whatever is written.
    const Stopwatch testing;
    const std::size_t bytes = (points.size() + 7) / 8;
    std::vector<std::uint8_t> bits(lights.size() * bytes);
    Occlusion occlusion(options.threads);
    {
        Progress progress("lights", std::max<std::size_t>(1, lights.size()));
        const auto keep = [&](std::size_t light, std::span<const std::uint8_t> occluded) {
            pack_bits(occluded, std::span(bits).subspan(light * bytes, bytes));
            progress.advance();
        };
        occlusion.test(world, points, lights, keep, receivers);
    }
    report.test_ms = testing.ms();

    const Stopwatch writing;
    write(options, bits, lights.size(), points.size());
    report.write_ms = writing.ms();
    report.points = points.size();
    report.lights = lights.size();
    report.triangles = scene->triangle_count();
    for (const std::uint8_t byte : bits) report.occluded += std::uint64_t(std::popcount(byte));
    report.threads = occlusion.threads();
    report.instruction_set = instruction_set();
    if (options.json) print(to_text(occlusion_json(report)));
    if (options.stats) print(occlusion_text(report));
    return kExitDone;
}

} // namespace firsthit::cli
