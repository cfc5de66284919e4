// write_film.cpp - writes a film's planes; the ending of each path chooses the format.
#include "film/endings.h"
#include "film/picture_files.h"

#include <firsthit/error.h>
#include <firsthit/file.h>
#include <firsthit/film.h>
#include <firsthit/picture.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace firsthit {

std::vector<std::string> channel_names(Aov aov, int channels)
{
    switch (aov) {
    case Aov::item:
        return {"item"};
    case Aov::depth:
        return {"Z"};
    case Aov::distance:
        return {"distance"};
    case Aov::uv:
        return {"U", "V"};
    case Aov::normal:
        return {"N.X", "N.Y", "N.Z"};
    case Aov::geometric_normal:
        return {"Ng.X", "Ng.Y", "Ng.Z"};
    case Aov::position:
        return {"P.X", "P.Y", "P.Z"};
    case Aov::albedo:
        return {"albedo.R", "albedo.G", "albedo.B"};
    case Aov::barycentric:
        return {"barycentric.U", "barycentric.V"};
    case Aov::tangent:
        return {"T.X", "T.Y", "T.Z", "T.W"};
    case Aov::metallic_roughness:
        return {"metallic", "roughness"};
    case Aov::emission:
        return {"emission.R", "emission.G", "emission.B"};
    case Aov::motion:
        return {"motion.X", "motion.Y"};
    case Aov::normal_camera:
        return {"Nc.X", "Nc.Y", "Nc.Z"};
    case Aov::position_camera:
        return {"Pc.X", "Pc.Y", "Pc.Z"};
    case Aov::motion_visible:
    case Aov::instance:
    case Aov::material:
    case Aov::node:
        return {std::string(aov_name(aov))};
    case Aov::lit:
        break;
    }
    std::vector<std::string> names;
    names.reserve(static_cast<std::size_t>(channels));
    for (int light = 0; light < channels; ++light) names.push_back(fmt::format("lit.{}", light));
    return names;
}

namespace {

/// Millimetres, and how many pixels are farther than they can say.
std::uint64_t write_millimetres(const PlaneView& plane, const std::string& path)
{
    constexpr double kMost = 65535;
    std::vector<std::uint16_t> value(plane.value.size());
    std::uint64_t beyond = 0;
    for (std::size_t k = 0; k < value.size(); ++k) {
        const float metres = plane.value[k];
        if (!(metres > 0) || std::isinf(metres)) continue; // nothing is seen
        const double millimetres = std::floor(double(metres) * 1000 + 0.5);
        if (millimetres > kMost) ++beyond;
        value[k] = static_cast<std::uint16_t>(std::clamp(millimetres, 1.0, kMost));
    }
    write_gray_png(value, plane.width, plane.height, path);
    return beyond;
}

} // namespace

void check_aov_path(const std::string& path)
{
    const std::string ending = ending_of(path, ".npy");
    if (ending == ".exr" || ending == ".npy" || ending == ".png") return check_output_path(path);
    throw ArgumentError(fmt::format("{}: unknown ending '{}' for a plane: accepted are .exr and "
                                    ".npy, and .png for depth and distance",
        path, ending));
}

void check_plane_path(Aov aov, const std::string& path, const std::string& format)
{
    plane_ending(aov, path, format);
    check_output_path(path);
}

std::uint64_t write_aov(const Film& film, Aov aov, const std::string& path)
{
    return write_plane(film, aov, path, {});
}

PlaneView checked_color(const Film& film)
{
    const PlaneView plane{
        .width = film.width, .height = film.height, .channels = 3, .value = film.color.value};
    check_shape(film, plane, "color");
    return plane;
}

PlaneView checked_plane(const Film& film, Aov aov)
{
    const bool lit = aov == Aov::lit;
    PlaneView plane{.width = film.width,
        .height = film.height,
        .channels = lit ? film[aov].channels : aov_channels(aov)};
    if (holds_ids(aov))
        plane.item = film.ids(aov);
    else
        plane.value = film[aov].value;
    if (lit && !plane.value.empty() && (plane.channels < 1 || plane.channels > int(kMaxLitLights)))
        throw ArgumentError(
            fmt::format("the film's plane 'lit' has {} lights: accepted are 1 to {}",
                plane.channels, kMaxLitLights));
    check_shape(film, plane, aov_name(aov));
    return plane;
}

std::uint64_t write_plane(
    const Film& film, Aov aov, const std::string& path, const std::string& format)
{
    const std::string ending = plane_ending(aov, path, format);
    const PlaneView plane = checked_plane(film, aov);
    if (ending == ".png") return write_millimetres(plane, path);
    if (ending == ".exr")
        write_exr(plane, channel_names(aov, plane.channels), path);
    else
        write_npy(plane, path);
    return 0;
}

} // namespace firsthit
