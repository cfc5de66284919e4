// picture_options.cpp - what stands behind the scene, and how pictures are written.
#include "options/picture_options.h"

#include "common/add_parsed.h"
#include "common/parse.h"
#include "common/usage.h"

#include <firsthit/error.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace firsthit::cli {
namespace {

constexpr double kBrightestBackdrop = 1e6;

bool parse_dither(const std::string& text)
{
    if (text == "on") return true;
    if (text == "off") return false;
    throw UsageError(fmt::format("'{}' is neither on nor off", text));
}

std::string parse_format(const std::string& text)
{
    for (const char* name : {"png", "jpg", "webp", "exr", "npy"})
        if (text == name) return "." + text;
    throw UsageError(
        fmt::format("'{}' is no format: accepted are png, jpg, webp, exr and npy", text));
}

glm::vec3 backdrop_color(const std::string& whole, const std::string& text)
{
    try {
        const glm::dvec3 color = parse_vector(text);
        if (std::min({color.x, color.y, color.z}) >= 0 &&
            std::max({color.x, color.y, color.z}) <= kBrightestBackdrop)
            return glm::vec3(color);
    } catch (const UsageError&) {
        // Said below, with all that is accepted.
    }
    throw UsageError(
        fmt::format("'{}' is no background: accepted are transparent, a colour r,g,b (linear, 0 "
                    "to 1 and above) and two as r,g,b:r,g,b, of the top and the bottom",
            whole));
}

/// The ending in lower case that counts for a path.
std::string ending_of_picture(const PictureOptions& options, const std::string& path)
{
    std::string ending =
        options.format.empty() ? std::filesystem::path(path).extension().string() : options.format;
    for (char& c : ending)
        if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return ending;
}

} // namespace

Backdrop parse_backdrop(const std::string& text)
{
    Backdrop backdrop;
    const std::size_t colon = text.find(':');
    if (text == "transparent")
        backdrop.transparent = true;
    else if (colon == std::string::npos)
        backdrop.color = backdrop_color(text, text);
    else
        backdrop.gradient = Gradient{.top = backdrop_color(text, text.substr(0, colon)),
            .bottom = backdrop_color(text, text.substr(colon + 1))};
    return backdrop;
}

void add_picture_options(CLI::App& app, PictureChoices& options)
{
    add_parsed(app, "--background", options.backdrop, parse_backdrop,
        "transparent|R,G,B|R,G,B:R,G,B",
        "What is behind the scene: nothing (.png, .webp and .exr with alpha), a linear colour, or "
        "one "
        "that goes from the top's to the bottom's; default the scene's own");
    add_parsed(app, "--dither", options.dither, parse_dither, "on|off",
        "Dither 8-bit colours, so that smooth shades have no steps; default on");
    add_parsed(
        app, "--quality", options.quality,
        [](const std::string& text) { return parse_integer(text, 1, 100); }, "N",
        "Of .jpg and .webp, 1 to 100; 100 makes .webp without loss; default 95");
    add_parsed(app, "--output-format", options.format, parse_format, "png|jpg|webp|exr|npy",
        "Of what goes to standard output, as with -o -; default png for pictures, npy for planes");
}

PictureOptions picture_options(
    const PictureChoices& options, const Tone& tone, const std::string& path)
{
    PictureOptions picture{.tone = tone, .dither = options.dither};
    picture.quality = options.quality.value_or(picture.quality);
    if (path == "-") picture.format = options.format.empty() ? ".png" : options.format;
    return picture;
}

std::string plane_format(const PictureChoices& options, const std::string& path)
{
    if (path != "-") return {};
    return options.format.empty() ? ".npy" : options.format;
}

void check_picture(const PictureChoices& options, const std::string& path)
{
    const PictureOptions picture = picture_options(options, {}, path);
    try {
        check_picture_path(path, picture);
    } catch (const ArgumentError& error) {
        throw UsageError(error.what());
    }
    const std::string ending = ending_of_picture(picture, path);
    const bool jpeg = ending == ".jpg" || ending == ".jpeg";
    if (jpeg && options.backdrop.transparent)
        throw UsageError(
            fmt::format("{}: JPEG has no transparency: --background transparent is for .png, "
                        ".webp and .exr",
                path));
    if (options.quality && !jpeg && ending != ".webp")
        throw UsageError(fmt::format("{}: --quality is of .jpg and .webp", path));
}

void apply(const Backdrop& backdrop, Scene& scene)
{
    if (!backdrop.needs_alpha() && !backdrop.color) return;
    scene.background = backdrop.color.value_or(glm::vec3(0));
    scene.environment.background = false;
}

} // namespace firsthit::cli
