// write_film.cpp - writes a film's planes; the ending of each path chooses the format.
#include "io/output_file.h"
#include "film/picture_files.h"

#include <firsthit/error.h>
#include <firsthit/file.h>
#include <firsthit/film.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace firsthit {

namespace {

/// The path's ending in lower case, such as ".png". A device such as /dev/null has none; returns
/// `of_device` for it.
std::string ending_of(const std::string& path, const char* of_device)
{
    std::string ending = std::filesystem::path(path).extension().string();
    if (ending.empty() && is_device(path)) return of_device;
    std::transform(ending.begin(), ending.end(), ending.begin(),
        [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return ending;
}

std::string color_ending(const std::string& path)
{
    const std::string ending = ending_of(path, ".png");
    if (ending == ".png" || ending == ".exr") return ending;
    throw ArgumentError(fmt::format(
        "{}: unknown ending '{}' for a picture: accepted are .png and .exr", path, ending));
}

std::string aov_ending(const std::string& path)
{
    const std::string ending = ending_of(path, ".npy");
    if (ending == ".exr" || ending == ".npy") return ending;
    throw ArgumentError(fmt::format(
        "{}: unknown ending '{}' for a plane: accepted are .exr and .npy", path, ending));
}

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
    case Aov::lit:
        break;
    }
    std::vector<std::string> names;
    for (int light = 0; light < channels; ++light) names.push_back(fmt::format("lit.{}", light));
    return names;
}

/// throws  ArgumentError where the plane is not (height, width, channels)
void check_shape(const Film& film, const PlaneView& plane, std::string_view name)
{
    const std::size_t pixels =
        film.width > 0 && film.height > 0
            ? static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height)
            : 0;
    const std::size_t values = plane.item.size() + plane.value.size();
    if (values == 0) throw ArgumentError(fmt::format("the film has no plane '{}'", name));
    if (values != pixels * static_cast<std::size_t>(plane.channels))
        throw ArgumentError(fmt::format("the film's plane '{}' has {} values, not {} x {} x {}",
            name, values, film.height, film.width, plane.channels));
}

} // namespace

void check_color_path(const std::string& path)
{
    color_ending(path);
    check_output_path(path);
}

void check_aov_path(const std::string& path)
{
    aov_ending(path);
    check_output_path(path);
}

void write_color(const Film& film, const std::string& path)
{
    const std::string ending = color_ending(path);
    const PlaneView plane{
        .width = film.width, .height = film.height, .channels = 3, .value = film.color.value};
    check_shape(film, plane, "color");
    if (ending == ".png")
        write_png(plane, path);
    else
        write_exr(plane, {"R", "G", "B"}, path);
}

void write_aov(const Film& film, Aov aov, const std::string& path)
{
    const std::string ending = aov_ending(path);
    const bool lit = aov == Aov::lit;
    PlaneView plane{.width = film.width,
        .height = film.height,
        .channels = lit ? film[aov].channels : aov_channels(aov)};
    if (aov == Aov::item)
        plane.item = film.item;
    else
        plane.value = film[aov].value;
    if (lit && !plane.value.empty() && (plane.channels < 1 || plane.channels > int(kMaxLitLights)))
        throw ArgumentError(
            fmt::format("the film's plane 'lit' has {} lights: accepted are 1 to {}",
                plane.channels, kMaxLitLights));
    check_shape(film, plane, aov_name(aov));
    if (ending == ".exr")
        write_exr(plane, channel_names(aov, plane.channels), path);
    else
        write_npy(plane, path);
}

} // namespace firsthit
