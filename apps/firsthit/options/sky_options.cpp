// sky_options.cpp - the light of scenes without lights, and the light of the sky.
#include "options/sky_options.h"

#include "common/add_parsed.h"
#include "common/parse.h"
#include "common/usage.h"

#include <firsthit/studio.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace firsthit::cli {
namespace {

/// Of a sky that is added to a scene with lights, and of what its ground sends back.
constexpr float kAddedSky = 0.3f;
constexpr float kGroundShare = 0.3f;

bool parse_on_off(const std::string& text)
{
    if (text == "on") return true;
    if (text == "off") return false;
    throw UsageError(fmt::format("'{}' is neither on nor off", text));
}

bool has_sky(const SkyOptions& options)
{
    return options.sky ? options.sky->directions > 0 : !options.draft;
}

} // namespace

SkyChoice parse_sky(const std::string& text)
{
    SkyChoice choice;
    const std::size_t comma = text.find(',');
    choice.directions = parse_integer(text.substr(0, comma), 0, Sky::kMostDirections);
    if (comma == std::string::npos) return choice;
    const glm::dvec3 color = parse_vector(text.substr(comma + 1));
    const double least = std::min({color.x, color.y, color.z});
    if (least < 0 || std::max({color.x, color.y, color.z}) > 1e6)
        throw UsageError(fmt::format(
            "'{}' is no colour: accepted are r,g,b, each 0 to 1,000,000", text.substr(comma + 1)));
    choice.color = glm::vec3(color);
    return choice;
}

void add_sky_options(CLI::App& app, SkyOptions& options)
{
    add_parsed(app, "--studio", options.studio, parse_on_off, "on|off",
        "A key light on the camera, a sky and a grey background, in the place of the scene's "
        "lights; "
        "default where the scene has no lights");
    add_parsed(app, "--sky", options.sky, parse_sky, "N[,R,G,B]",
        "Light from N directions of the sky, 0 to 256, that hollows keep out: 16 is quick, 64 is "
        "smooth; and its colour, linear. Default 24 in the studio, else 0: no sky");
    app.add_flag(
        "--draft", options.draft, "Quickly: without the sky, and with one ray a pixel (--aa 1)");
}

void check(const SkyOptions& options, bool lights)
{
    if (options.studio.value_or(false) && lights)
        throw UsageError("--studio on has a light of its own, --light gives others: say one");
    if (options.draft && options.sky && options.sky->directions > 0)
        throw UsageError("--draft leaves the sky out, --sky adds one: say one");
}

bool wants_studio(const SkyOptions& options, const Scene& scene, bool lights)
{
    return options.studio.value_or(!lights && !has_own_lights(scene));
}

void apply_studio(const SkyOptions& options, Scene& scene)
{
    set_up_studio(scene, has_sky(options));
}

void apply(const SkyOptions& options, bool studio, Settings& settings)
{
    // Also where there is none: whoever turns it on later, as in the window, gets the one of --sky.
    settings.sky = studio ? studio_sky() : Sky{};
    if (!studio) settings.sky.color = glm::vec3(kAddedSky);
    if (options.sky) {
        settings.sky.directions = options.sky->directions;
        if (options.sky->color) settings.sky.color = *options.sky->color;
    }
    if (!studio || (options.sky && options.sky->color))
        settings.sky.ground = kGroundShare * settings.sky.color;
    if (studio ? !has_sky(options) : !options.sky) settings.sky.directions = 0;
}

} // namespace firsthit::cli
