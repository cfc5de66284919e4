// environment_options.h - the light from all around the scene, and how bright pictures are.
#pragma once

#include <firsthit/film.h>
#include <firsthit/scene.h>

#include <memory>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace firsthit::cli {

struct EnvironmentOptions {
    std::string name; // empty: the scene's own; none, studio, r,g,b or a file
    std::optional<double> rotation_rad;
    std::optional<double> strength;
    std::optional<bool> background;
    Tone tone;
};

/// --environment, --environment-rotation, --environment-strength, --environment-background,
/// --exposure, --tonemap
void add_environment_options(CLI::App& app, EnvironmentOptions& options);

/// "none", "aces" or "khronos-pbr-neutral". throws  UsageError
ToneMap parse_tone_map(const std::string& text);

/// Replaces what was given of the scene's environment; reads its file, which is added to Scene::files.
/// throws  UsageError: no such kind; as load_environment
void apply(const EnvironmentOptions& options, Scene& scene);

} // namespace firsthit::cli
