// environment_options.cpp - the light from all around the scene, and how bright pictures are.
#include "options/environment_options.h"

#include "common/add_parsed.h"
#include "common/parse.h"
#include "common/usage.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace firsthit::cli {
namespace {

constexpr double kRadians = 3.14159265358979323846 / 180;
constexpr double kMostStrength = 1e6;
constexpr double kMostExposure = 100;

double parse_range(const std::string& text, double least, double most)
{
    const double value = parse_number(text);
    if (least <= value && value <= most) return value;
    throw UsageError(fmt::format("'{}' is out of range: {} to {}", text, least, most));
}

bool parse_switch(const std::string& text)
{
    if (text == "on") return true;
    if (text == "off") return false;
    throw UsageError(fmt::format("'{}' is neither on nor off", text));
}

/// "r,g,b", the same light from everywhere, or a file, which is added to `files`.
std::shared_ptr<const EnvironmentMap> parse_environment(
    const std::string& text, std::vector<std::string>& files)
{
    glm::dvec3 color(0);
    try {
        color = parse_vector(text);
    } catch (const UsageError&) {
        if (std::filesystem::path(text).has_extension()) {
            files.push_back(text);
            return load_environment(text);
        }
        throw UsageError(fmt::format(
            "--environment: '{}' is none of none, studio, a colour r,g,b and a file .hdr or .exr",
            text));
    }
    if (std::min({color.x, color.y, color.z}) < 0)
        throw UsageError(fmt::format("--environment: '{}': light is not below 0", text));
    return constant_environment(glm::vec3(color));
}

} // namespace

ToneMap parse_tone_map(const std::string& text)
{
    if (text == "none") return ToneMap::none;
    if (text == "aces") return ToneMap::aces;
    if (text == "khronos-pbr-neutral") return ToneMap::khronos_pbr_neutral;
    throw UsageError(fmt::format(
        "'{}' is no tone mapping: accepted are none, aces and khronos-pbr-neutral", text));
}

void add_environment_options(CLI::App& app, EnvironmentOptions& options)
{
    app.add_option("--environment", options.name,
           "Light from all around, which metallic-roughness materials reflect: a file .hdr or .exr "
           "(equirectangular), a colour r,g,b, studio or none; default the scene's own, which is "
           "studio for glTF")
        ->type_name("FILE|R,G,B|studio|none");
    const auto degrees = [](const std::string& text) {
        return parse_range(text, -36000, 36000) * kRadians;
    };
    add_parsed(app, "--environment-rotation", options.rotation_rad, degrees, "DEG",
        "Turn it about the y axis, counter-clockwise seen from above; default 0");
    const auto strength = [](const std::string& text) {
        return parse_range(text, 0, kMostStrength);
    };
    add_parsed(app, "--environment-strength", options.strength, strength, "X",
        "Multiply its light, 0 to 1,000,000; default 1");
    add_parsed(app, "--environment-background", options.background, parse_switch, "on|off",
        "Show it where nothing is seen; default off");
    const auto exposure = [](const std::string& text) {
        return parse_range(text, -kMostExposure, kMostExposure);
    };
    add_parsed(app, "--exposure", options.tone.exposure_ev, exposure, "EV",
        "Multiply the light of .png pictures by 2^EV, -100 to 100; default 0");
    add_parsed(app, "--tonemap", options.tone.map, parse_tone_map, "none|aces|khronos-pbr-neutral",
        "How .png pictures show light above 1; default none: as 1");
}

void apply(const EnvironmentOptions& options, Scene& scene)
{
    Environment& environment = scene.environment;
    if (options.name == "none") {
        environment = {};
    } else if (options.name == "studio") {
        environment.map = studio_environment();
    } else if (!options.name.empty()) {
        environment.map = parse_environment(options.name, scene.files);
    }
    environment.rotation_rad = options.rotation_rad.value_or(environment.rotation_rad);
    environment.strength =
        static_cast<float>(options.strength.value_or(double(environment.strength)));
    environment.background = options.background.value_or(environment.background);
    if (!environment.map && options.name != "none" &&
        (options.rotation_rad || options.strength || options.background))
        throw UsageError("the scene has no environment to change: say --environment too");
}

} // namespace firsthit::cli
