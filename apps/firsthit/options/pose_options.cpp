// pose_options.cpp - which clip, camera and time of a scene.
#include "options/pose_options.h"

#include <firsthit/error.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <vector>

namespace firsthit::cli {
namespace {

/// The number of what is called `chosen`, by name or by number.
std::int32_t number_of(const std::string& chosen, const std::vector<std::string>& names,
    const char* what, const std::string& scene)
{
    for (std::size_t k = 0; k < names.size(); ++k)
        if (names[k] == chosen) return static_cast<std::int32_t>(k);
    std::size_t number = 0;
    const char* end = chosen.data() + chosen.size();
    const auto [rest, error] = std::from_chars(chosen.data(), end, number);
    if (error == std::errc() && rest == end && number < names.size())
        return static_cast<std::int32_t>(number);
    std::string list;
    for (std::size_t k = 0; k < names.size(); ++k)
        list += fmt::format("{}{} '{}'", k > 0 ? ", " : "", k, names[k]);
    throw ArgumentError(fmt::format(
        "{}: there is no {} '{}'; it has {}", scene, what, chosen, list.empty() ? "none" : list));
}

} // namespace

void add_pose_options(CLI::App& app, PoseOptions& options)
{
    app.add_option("--clip", options.clip,
           "The animation, by name or number, or none: the scene at rest; default the first")
        ->type_name("NAME|N");
    app.add_option("--camera", options.camera,
           "The scene's camera, by name or number; default the first. Of render, mask "
           "and visible also a file or folder of calibrated cameras (docs/cameras.md): .json with "
           "K, NeRF's "
           "transforms.json, COLMAP's text files")
        ->type_name("NAME|N|FILE");
}

PoseSettings pose_settings(const PoseOptions& options, const Scene& scene)
{
    PoseSettings settings;
    if (options.clip == "none") {
        settings.clip = PoseSettings::kRest;
    } else if (!options.clip.empty()) {
        std::vector<std::string> names;
        for (const Clip& clip : scene.clips) names.push_back(clip.name);
        settings.clip = number_of(options.clip, names, "clip", scene.name);
    }
    if (!options.camera.empty()) {
        std::vector<std::string> names;
        for (const SceneCamera& camera : scene.cameras) names.push_back(camera.name);
        settings.camera = number_of(options.camera, names, "camera", scene.name);
    }
    settings.time_s = scene.begin_s(settings.clip);
    return settings;
}

} // namespace firsthit::cli
