// render_options.h - what `firsthit render` was asked for.
#pragma once

#include "common/parse.h"
#include "options/data_options.h"
#include "options/engine_options.h"
#include "options/environment_options.h"
#include "options/ground_options.h"
#include "options/light_options.h"
#include "options/picture_options.h"
#include "options/picture_set_options.h"
#include "options/sky_options.h"

#include <firsthit/render.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace firsthit::cli {

/// Frames: none chosen is one picture, or of a film the whole clip.
struct RenderOptions : PictureSetOptions {
    LightOptions light;
    EnvironmentOptions environment;
    SkyOptions sky;
    GroundOptions ground;
    EngineOptions engine;
    PictureChoices picture;
    std::string output; // empty: no picture; "-": standard output
    std::vector<AovOutput> aovs;
    DataOptions data;
    std::optional<int> samples;  // N x N everywhere; none: see adaptive
    std::optional<int> adaptive; // N x N where there are edges; none: adaptive_samples
    int tile_size = 64;
    bool stats = false;
    std::string stats_json; // empty: none; "-": stdout
};

void add_render_options(CLI::App& app, RenderOptions& options);

/// Finds what cannot work before the scene is loaded.
/// throws  UsageError: nothing is asked for, an ending, a pattern of frames, a file named twice, an
///         option of shadow maps without them, two of --interleave, --samples and --aa, exact
///         shadows or --aa of the gpu engine
///         FileError: a folder is missing or may not be written
///         DeviceError: the film is larger than the machine's memory
void check(const RenderOptions& options);

/// Finds outputs, of all frames, that would replace a file that the scene was read from.
/// throws  FileError that names both
void check_inputs_stay(const RenderOptions& options, const Scene& scene);

/// The name of a file for one frame: numbered where there are several.
std::string file_name(const RenderOptions& options, const std::string& text, int frame);

/// Whether there is more than one frame: several pictures, or a film.
bool is_numbered(const RenderOptions& options);

/// Whether the picture is a film.
bool is_film(const RenderOptions& options);

/// The frames of a scene; those of a film that chooses none are the whole clip.
/// pose    of the chosen clip, at its begin
/// throws  UsageError: nothing moves in a film; as frames_of of picture sets
Frames frames_of(const RenderOptions& options, const Scene& scene, const PoseSettings& pose);

/// The planes' files and the picture's, as they were typed.
std::vector<std::string> outputs(const RenderOptions& options);

/// What a film of these options and so many lights takes.
std::uint64_t film_bytes(const RenderOptions& options, std::size_t lights);

/// throws  DeviceError: that is more than the machine's memory
void check_memory(const RenderOptions& options, std::size_t lights);

/// Settings::adaptive: what was asked for, else 4 for a picture of one ray a pixel by an engine that
/// knows it, but for --draft, else 1.
int adaptive_samples(const RenderOptions& options);

/// What the options replace in every scene that is read: lights, environment, studio, background. It has a copy of
/// the options, so that a thread that reads ahead may call it.
/// options  after read_files and turn_suns
std::function<void(Scene&)> scene_changes(const RenderOptions& options);

/// What the renderer is told.
Settings render_settings(const RenderOptions& options);

} // namespace firsthit::cli
