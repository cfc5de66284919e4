// light_options.cpp - which lights shine on the scene, and how their shadows are found.
#include "options/light_options.h"

#include "common/parse.h"
#include "common/usage.h"

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <string_view>

namespace firsthit::cli {

namespace {

constexpr double kHalfRadians = 3.14159265358979323846 / 360; // half an angle in degrees

constexpr const char* kAccepted =
    "accepted are point:x,y,z, spot:x,y,z,dx,dy,dz,DEG[,INNER] and directional:dx,dy,dz, as "
    "point:0,5,0 or spot:0,5,0,0,-1,0,40,30";

struct Words {
    std::string_view kind;
    std::vector<double> number;
};

Words words_of(const std::string& text)
{
    Words words;
    const std::size_t colon = text.find(':');
    words.kind = std::string_view(text).substr(0, colon);
    if (colon == std::string::npos) return words;
    std::size_t first = colon + 1;
    for (;;) {
        const std::size_t end = std::min(text.find(',', first), text.size());
        words.number.push_back(parse_number(text.substr(first, end - first)));
        if (end == text.size()) return words;
        first = end + 1;
    }
}

glm::dvec3 direction_of(const std::string& text, const glm::dvec3& v)
{
    const glm::dvec3 size = glm::abs(v);
    const double largest = std::max({size.x, size.y, size.z});
    if (1e-100 <= largest && largest <= 1e100) return v;
    throw UsageError(fmt::format(
        "'{}' has no direction: accepted is a length above 1e-100 and below 1e100", text));
}

Light spot_of(const std::string& text, const std::vector<double>& number)
{
    Light light{.kind = Light::Kind::spot, .position = {number[0], number[1], number[2]}};
    light.direction = direction_of(text, {number[3], number[4], number[5]});
    const double degrees = number[6], inner = number.size() > 7 ? number[7] : 0;
    light.outer_rad = degrees * kHalfRadians;
    light.inner_rad = inner * kHalfRadians;
    if (!(0 < degrees && degrees < 180 && light.outer_rad > 0))
        throw UsageError(
            fmt::format("'{}': {} is no angle above 0 and below 180 degrees", text, degrees));
    if (!(0 <= inner && inner <= degrees))
        throw UsageError(fmt::format(
            "'{}': the inner angle is {}: accepted are 0 to {} degrees", text, inner, degrees));
    return light;
}

} // namespace

Light parse_light(const std::string& text)
{
    const Words words = words_of(text);
    const std::vector<double>& number = words.number;
    if (words.kind == "point" && number.size() == 3)
        return {.position = {number[0], number[1], number[2]}};
    if (words.kind == "directional" && number.size() == 3)
        return {.kind = Light::Kind::directional,
            .direction = direction_of(text, {number[0], number[1], number[2]})};
    if (words.kind == "spot" && (number.size() == 7 || number.size() == 8))
        return spot_of(text, number);
    throw UsageError(fmt::format("'{}' is no light: {}", text, kAccepted));
}

Shadows parse_shadows(const std::string& text)
{
    if (text == "none") return Shadows::none;
    if (text == "map") return Shadows::map;
    if (text == "exact") return Shadows::exact;
    throw UsageError(
        fmt::format("'{}' is no kind of shadows: accepted are none, map and exact", text));
}

void add_light_options(CLI::App& app, LightOptions& options)
{
    app.add_option_function<std::vector<std::string>>(
           "--light",
           [&options](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) {
                   try {
                       options.lights.push_back(parse_light(text));
                   } catch (const UsageError& error) {
                       throw UsageError(std::string("--light: ") + error.what());
                   }
               }
           },
           "A white light instead of the scene's; may be repeated: point:x,y,z or "
           "spot:x,y,z,dx,dy,dz,DEG[,INNER] (full angles of the cone and of its evenly lit middle) "
           "or directional:dx,dy,dz (the way the light goes)")
        ->type_name("LIGHT")
        ->allow_extra_args(false);
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
