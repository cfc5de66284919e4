// parse_light.cpp - a light by words of the command line.
#include "inputs/parse_light.h"

#include "common/parse.h"
#include "common/usage.h"

#include <firsthit/error.h>
#include <firsthit/sun.h>

#include <fmt/format.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

namespace firsthit::cli {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr std::string_view kOnCamera = "camera:";
constexpr double kBrightest = 1e6;

constexpr const char* kAccepted =
    "accepted are point:x,y,z, spot:x,y,z,dx,dy,dz,DEG[,INNER], directional:dx,dy,dz and "
    "sun:LAT,LON,TIME, "
    "then ,color=r,g,b ,intensity=I ,falloff=none|square, as point:0,5,0 or "
    "spot:0,5,0,0,-1,0,40,30,color=1,0.5,0";

/// A light's text in parts.
struct LightText {
    std::string whole;
    bool on_camera = false;
    std::string kind;
    std::vector<std::string> places; // before the first word with =
    std::vector<std::pair<std::string, std::string>>
        settings; // key and value; commas belong to the value
};

LightText parts_of(const std::string& text)
{
    LightText parts;
    parts.whole = text;
    std::string_view rest = text;
    if (rest.starts_with(kOnCamera)) {
        parts.on_camera = true;
        rest.remove_prefix(kOnCamera.size());
    }
    const std::size_t colon = rest.find(':');
    parts.kind = rest.substr(0, colon);
    if (colon == std::string_view::npos) return parts;
    for (std::size_t first = colon + 1;;) {
        const std::size_t end = std::min(rest.find(',', first), rest.size());
        const std::string word(rest.substr(first, end - first));
        const std::size_t sign = word.find('=');
        if (sign != std::string::npos)
            parts.settings.emplace_back(word.substr(0, sign), word.substr(sign + 1));
        else if (parts.settings.empty())
            parts.places.push_back(word);
        else
            parts.settings.back().second += "," + word;
        if (end == rest.size()) return parts;
        first = end + 1;
    }
}

[[noreturn]] void refuse(const LightText& parts, const std::string& why)
{
    throw UsageError(fmt::format("'{}': {}", parts.whole, why));
}

glm::dvec3 direction_of(const LightText& parts, const glm::dvec3& v)
{
    const glm::dvec3 size = glm::abs(v);
    const double largest = std::max({size.x, size.y, size.z});
    if (1e-100 <= largest && largest <= 1e100) return v;
    throw UsageError(fmt::format(
        "'{}' has no direction: accepted is a length above 1e-100 and below 1e100", parts.whole));
}

Light spot_of(const LightText& parts, const std::vector<double>& number)
{
    Light light{.kind = Light::Kind::spot, .position = {number[0], number[1], number[2]}};
    light.direction = direction_of(parts, {number[3], number[4], number[5]});
    const double degrees = number[6], inner = number.size() > 7 ? number[7] : 0;
    light.outer_rad = degrees * kDegree / 2;
    light.inner_rad = inner * kDegree / 2;
    if (!(0 < degrees && degrees < 180 && light.outer_rad > 0))
        refuse(parts, fmt::format("{} is no angle above 0 and below 180 degrees", degrees));
    if (!(0 <= inner && inner <= degrees))
        refuse(parts,
            fmt::format("the inner angle is {}: accepted are 0 to {} degrees", inner, degrees));
    return light;
}

/// The value of a setting, taken out. Nothing where it is missing.
std::string take_setting(LightText& parts, std::string_view key)
{
    const auto found = std::find_if(parts.settings.begin(), parts.settings.end(),
        [&](const auto& setting) { return setting.first == key; });
    if (found == parts.settings.end()) return {};
    std::string value = found->second;
    parts.settings.erase(found);
    if (value.empty()) refuse(parts, fmt::format("{}= has no value", key));
    return value;
}

Light sun_of(LightText& parts)
{
    const double latitude = parse_number(parts.places[0]),
                 longitude = parse_number(parts.places[1]);
    const std::string north = take_setting(parts, "north");
    SunPosition sun;
    try {
        sun = sun_position(latitude, longitude, unix_time(parts.places[2]));
    } catch (const ArgumentError& error) {
        refuse(parts, error.what());
    }
    if (sun.elevation_rad <= 0)
        refuse(parts, fmt::format("the sun is {:.1f} degrees below the horizon then",
                          -sun.elevation_rad / kDegree));
    if (!north.empty()) sun.azimuth_rad += parse_number(north) * kDegree;
    return {.kind = Light::Kind::directional, .direction = -to_sun(sun)};
}

Light kind_of(LightText& parts)
{
    if (parts.kind == "sun" && parts.places.size() == 3 && !parts.on_camera) return sun_of(parts);
    std::vector<double> number;
    for (const std::string& place : parts.places) number.push_back(parse_number(place));
    if (parts.kind == "point" && number.size() == 3)
        return {.position = {number[0], number[1], number[2]}};
    if (parts.kind == "directional" && number.size() == 3)
        return {.kind = Light::Kind::directional,
            .direction = direction_of(parts, {number[0], number[1], number[2]})};
    if (parts.kind == "spot" && (number.size() == 7 || number.size() == 8))
        return spot_of(parts, number);
    throw UsageError(fmt::format("'{}' is no light: {}", parts.whole, kAccepted));
}

double brightness_of(const LightText& parts, double value, const char* what)
{
    if (0 <= value && value <= kBrightest) return value;
    refuse(parts, fmt::format("{} {} is out of range: 0 to 1000000", what, value));
}

} // namespace

bool is_sun(const std::string& text)
{
    return text.starts_with("sun:");
}

Light parse_light(const std::string& text)
{
    LightText parts = parts_of(text);
    Light light = kind_of(parts);
    glm::dvec3 color(1);
    if (const std::string value = take_setting(parts, "color"); !value.empty()) {
        color = parse_vector(value);
        for (int c = 0; c < 3; ++c) brightness_of(parts, color[c], "the colour");
    }
    if (const std::string value = take_setting(parts, "intensity"); !value.empty())
        color *= brightness_of(parts, parse_number(value), "the intensity");
    light.color = glm::vec3(color);
    if (const std::string value = take_setting(parts, "falloff"); !value.empty()) {
        if (light.kind == Light::Kind::directional)
            refuse(parts, "falloff is of point and spot: parallel light does not fade");
        if (value != "none" && value != "square")
            refuse(parts, fmt::format("falloff '{}': accepted are none and square", value));
        light.inverse_square = value == "square";
    }
    if (!parts.settings.empty())
        refuse(parts,
            fmt::format("'{}=' is not known here, or given twice: accepted are color, intensity, "
                        "falloff, and north of a sun",
                parts.settings[0].first));
    light.on_camera = parts.on_camera;
    return light;
}

glm::dvec3 turned_up(const glm::dvec3& d, const glm::dvec3& up_axis)
{
    if (up_axis.z > 0) return {d.x, -d.z, d.y};
    if (up_axis.z < 0) return {d.x, d.z, -d.y};
    if (up_axis.x > 0) return {d.y, -d.x, d.z};
    if (up_axis.x < 0) return {-d.y, d.x, d.z};
    if (up_axis.y < 0) return {-d.x, -d.y, d.z};
    return d;
}

} // namespace firsthit::cli
