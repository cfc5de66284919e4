// render_options.h - what `firsthit render` was asked for.
#pragma once

#include "options/camera_options.h"
#include "options/engine_options.h"
#include "options/light_options.h"
#include "common/parse.h"
#include "options/scene_options.h"

#include <firsthit/render.h>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace firsthit::cli {

struct RenderOptions {
    SceneOptions scene;
    CameraOptions camera;
    LightOptions light;
    EngineOptions engine;
    std::string output; // empty: no picture
    std::vector<AovOutput> aovs;
    std::optional<double> time_s; // none: the scene's begin
    std::vector<double> frames;   // times; empty: one picture at time_s
    int samples = 1;
    int threads = 0;
    int tile_size = 64;
    bool stats = false;
    std::string stats_json; // empty: none; "-": stdout
};

void add_render_options(CLI::App& app, RenderOptions& options);

/// Finds what cannot work before the scene is loaded.
/// throws  UsageError: nothing is asked for, an ending, a pattern of frames, a file named twice, an
///         option of shadow maps without them, --interleave and --samples together, exact shadows of
///         the gpu engine
///         FileError: a folder is missing or may not be written
///         DeviceError: the film is larger than the machine's memory
void check(const RenderOptions& options);

/// Finds outputs, of all frames, that would replace a file that the scene was read from.
/// throws  FileError that names both
void check_inputs_stay(const RenderOptions& options, const Scene& scene);

/// The name of a file for one frame: numbered where there are several.
std::string file_name(const RenderOptions& options, const std::string& text, int frame);

/// What a film of these options and so many lights takes.
std::uint64_t film_bytes(const RenderOptions& options, std::size_t lights);

/// throws  DeviceError: that is more than the machine's memory
void check_memory(const RenderOptions& options, std::size_t lights);

/// What the renderer is told.
Settings render_settings(const RenderOptions& options);

} // namespace firsthit::cli
