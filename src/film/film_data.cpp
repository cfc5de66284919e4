// film_data.cpp - a film for other programs: 8-bit pixels, and all planes in one file.
#include "film/picture_codes.h"

#include <firsthit/error.h>
#include <firsthit/file.h>
#include <firsthit/film_data.h>

#include <fmt/format.h>

#include <filesystem>

namespace firsthit {
namespace {

void check_planes_ending(const std::string& path)
{
    const std::string ending = std::filesystem::path(path).extension().string();
    if (ending == ".exr" || ending == ".EXR") return;
    throw ArgumentError(fmt::format(
        "{}: unknown ending '{}' for a file of planes: accepted is .exr", path, ending));
}

} // namespace

std::vector<std::uint8_t> srgb_pixels(const Film& film, const Tone& tone, bool dither)
{
    PlaneView color = checked_color(film);
    std::vector<float> shown;
    if (tone.exposure_ev != 0 || tone.map != ToneMap::none) {
        shown = toned(film.color.value, tone);
        color.value = shown;
    }
    const PictureCodes codes(color, {}, dither);
    std::vector<std::uint8_t> pixels(color.value.size());
    const std::size_t row = std::size_t(color.width) * 3;
    for (int y = 0; y < color.height; ++y)
        codes.row(y, std::span(pixels).subspan(std::size_t(y) * row, row));
    return pixels;
}

void check_planes_path(const std::string& path)
{
    check_planes_ending(path);
    check_output_path(path);
}

void write_planes(const Film& film, bool color, std::span<const Aov> aovs, const std::string& path)
{
    check_planes_ending(path);
    std::vector<ExrPlane> planes;
    if (color) planes.push_back({checked_color(film), {"R", "G", "B"}});
    if (color && !film.alpha.empty())
        planes.push_back({{film.width, film.height, 1, film.alpha.value}, {"A"}});
    for (const Aov aov : aovs) {
        const PlaneView plane = checked_plane(film, aov);
        planes.push_back({plane, channel_names(aov, plane.channels)});
    }
    if (planes.empty()) throw ArgumentError(fmt::format("{}: there is no plane to write", path));
    write_exr(planes, path);
}

} // namespace firsthit
