// scene_options.h - which scene, and how its file is read.
#pragma once

#include "options/pose_options.h"

#include <firsthit/scene.h>

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace firsthit::cli {

struct SceneOptions {
    std::string name;
    LoadSettings load;
    PoseOptions pose;
    std::optional<double> fps;  // of a sequence, and of frames where the command has them
    bool fps_of_frames = false; // --fps means something for a single scene too
    std::string format; // of standard input, an ending as ".ply"; empty where a file is read

    /// What messages call the scene, with the ending of its kind.
    std::string shown_name() const { return name == "-" ? "standard input" + format : name; }
};

/// SCENE, --format, --fps, --scene, --clip, --camera, --crease-angle, --sphere-segments, --cone-segments,
/// --strict. Who reads it: scene_source.h
void add_scene_options(CLI::App& app, SceneOptions& options);

} // namespace firsthit::cli
