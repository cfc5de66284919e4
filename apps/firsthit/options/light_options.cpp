// light_options.cpp - which lights shine on the scene, and how their shadows are found.
#include "options/light_options.h"

#include "common/add_parsed.h"
#include "common/parse.h"
#include "common/usage.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace firsthit::cli {

Shadows parse_shadows(const std::string& text)
{
    if (text == "none") return Shadows::none;
    if (text == "map") return Shadows::map;
    if (text == "exact") return Shadows::exact;
    throw UsageError(
        fmt::format("'{}' is no kind of shadows: accepted are none, map and exact", text));
}

void add_light_option(CLI::App& app, LightOptions& options)
{
    app.add_option_function<std::vector<std::string>>(
           "--light",
           [&options](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) {
                   try {
                       if (is_sun(text)) options.suns.push_back(options.lights.size());
                       options.lights.push_back(parse_light(text));
                   } catch (const UsageError& error) {
                       throw UsageError(std::string("--light: ") + error.what());
                   }
               }
           },
           "A light instead of the scene's; may be repeated: point:x,y,z or "
           "spot:x,y,z,dx,dy,dz,DEG[,INNER] (full angles of the cone and of its evenly lit middle) "
           "or directional:dx,dy,dz (the way the light goes) or sun:LAT,LON,TIME (as "
           "sun:52.5,13.4,2026-06-21T14:00+02:00), then ,color=r,g,b ,intensity=I "
           ",falloff=none|square "
           ",north=DEG of a sun; camera: before it hangs it on the camera")
        ->type_name("LIGHT")
        ->allow_extra_args(false);
}

void add_light_options(CLI::App& app, LightOptions& options)
{
    add_light_option(app, options);
    add_parsed(app, "--shadows", options.shadows, parse_shadows, "none|map|exact",
        "none: every light reaches everything; map: shadow maps, quicker and approximate; exact: "
        "what a "
        "shadow ray for every sample and light says; default exact");
    const auto integer = [](int low, int high) {
        return [low, high](const std::string& text) { return parse_integer(text, low, high); };
    };
    add_parsed(app, "--shadow-map-size", options.shadow_map_size, integer(16, 8192), "N",
        "Texels on a shadow map's longer side, 16 to 8192; default by the camera, the picture and "
        "the light");
    const auto bias = [](const std::string& text) {
        const double value = parse_number(text);
        if (value >= 0) return value;
        throw UsageError(fmt::format("'{}' is below 0", text));
    };
    add_parsed(app, "--shadow-bias", options.shadow_bias, bias, "X",
        "How much nearer to the light a shadow map's depth has to be than a point to shadow it, "
        "world "
        "units, 0 or above; default by its texels and the surface");
    add_parsed(app, "--shadow-filter", options.shadow_filter, integer(1, 15), "N",
        "Soften the borders of shadow maps: N x N texels are compared, 1 to 15; default 1: hard");
}

void check(const LightOptions& options, Engine engine)
{
    if (options.shadows == Shadows::map) return;
    if (options.shadows == Shadows::automatic && engine != Engine::cpu) return;
    const char* name = options.shadow_map_size ? "--shadow-map-size"
                       : options.shadow_bias   ? "--shadow-bias"
                       : options.shadow_filter ? "--shadow-filter"
                                               : nullptr;
    if (name) throw UsageError(fmt::format("{} is of shadow maps: say --shadows map too", name));
}

void turn_suns(const glm::dvec3& up_axis, LightOptions& options)
{
    for (const std::size_t k : options.suns)
        options.lights[k].direction = turned_up(options.lights[k].direction, up_axis);
    options.suns.clear();
}

void apply(const LightOptions& options, Scene& scene)
{
    if (!options.lights.empty()) scene.lights = options.lights;
}

void apply(const LightOptions& options, Settings& settings)
{
    settings.shadows = options.shadows;
    settings.shadow_map_size = options.shadow_map_size.value_or(settings.shadow_map_size);
    settings.shadow_bias = options.shadow_bias.value_or(settings.shadow_bias);
    settings.shadow_filter = options.shadow_filter.value_or(settings.shadow_filter);
}

} // namespace firsthit::cli
