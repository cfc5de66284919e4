// write_picture.cpp - writes a film's colours; the ending of the path chooses the format.
#include "film/endings.h"
#include "film/picture_codes.h"
#include "film/picture_files.h"

#include <firsthit/error.h>
#include <firsthit/file.h>
#include <firsthit/picture.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace firsthit {
namespace {

/// The ending that says how a picture is written, of those that this build knows.
std::string picture_ending(const std::string& path, const std::string& format)
{
    std::string ending = format.empty() ? ending_of(path, ".png") : format;
    const std::vector<std::string> accepted = picture_endings();
    if (std::find(accepted.begin(), accepted.end(), ending) != accepted.end()) return ending;
    std::string list;
    for (std::size_t k = 0; k < accepted.size(); ++k)
        list += (k == 0 ? "" : k + 1 == accepted.size() ? " and " : ", ") + accepted[k];
    const bool of_build = ending == ".jpg" || ending == ".jpeg" || ending == ".webp";
    throw ArgumentError(fmt::format("{}: {} ending '{}' for a picture: accepted are {}", path,
        of_build ? "this program was built without the library for the" : "unknown", ending, list));
}

bool is_jpeg(const std::string& ending)
{
    return ending == ".jpg" || ending == ".jpeg";
}

std::string checked_ending(const std::string& path, const PictureOptions& options)
{
    if (options.quality < 1 || options.quality > 100)
        throw ArgumentError(fmt::format("quality {} is out of range: 1 to 100", options.quality));
    return picture_ending(path, options.format);
}

/// Colours without the black background that they hold.
std::vector<float> straight(const Film& film)
{
    std::vector<float> color = film.color.value;
    for (std::size_t k = 0; k < film.alpha.value.size(); ++k) {
        const float alpha = film.alpha.value[k];
        for (std::size_t c = 0; c < 3; ++c)
            color[3 * k + c] = alpha > 0 ? color[3 * k + c] / alpha : 0.0f;
    }
    return color;
}

} // namespace

std::vector<std::string> picture_endings()
{
    std::vector<std::string> endings = {".png", ".exr"};
    if (can_write_jpeg()) endings.insert(endings.end(), {".jpg", ".jpeg"});
    if (can_write_webp()) endings.emplace_back(".webp");
    return endings;
}

void check_color_path(const std::string& path)
{
    check_picture_path(path);
}

void check_picture_path(const std::string& path, const PictureOptions& options)
{
    checked_ending(path, options);
    check_output_path(path);
}

void write_color(const Film& film, const std::string& path)
{
    write_color(film, path, {});
}

void write_color(const Film& film, const std::string& path, const Tone& tone)
{
    write_picture(film, path, {.tone = tone, .dither = false});
}

void write_picture(const Film& film, const std::string& path, const PictureOptions& options)
{
    const std::string ending = checked_ending(path, options);
    PlaneView plane{
        .width = film.width, .height = film.height, .channels = 3, .value = film.color.value};
    check_shape(film, plane, "color");
    const std::span<const float> alpha = film.alpha.value;
    if (!alpha.empty()) {
        check_shape(film, {film.width, film.height, 1, alpha}, "alpha");
        if (is_jpeg(ending))
            throw ArgumentError(fmt::format(
                "{}: JPEG has no transparency: accepted are .png, .webp and .exr", path));
    }
    if (ending == ".exr") {
        if (!alpha.empty()) return write_rgba_exr(plane, alpha, path);
        return write_exr(plane, {"R", "G", "B"}, path);
    }
    std::vector<float> shown;
    if (!alpha.empty()) shown = straight(film);
    if (options.tone.exposure_ev != 0 || options.tone.map != ToneMap::none)
        shown = toned(alpha.empty() ? film.color.value : shown, options.tone);
    if (!shown.empty()) plane.value = shown;
    const PictureCodes picture(plane, alpha, options.dither, options.origin);
    if (is_jpeg(ending)) return write_jpeg(picture, options.quality, path);
    if (ending == ".webp") return write_webp(picture, options.quality, path);
    write_png(picture, path);
}

} // namespace firsthit
