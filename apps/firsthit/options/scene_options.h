// scene_options.h - which scene, and how its file is read.
#pragma once

#include <firsthit/scene.h>

#include <CLI/CLI.hpp>

#include <string>

namespace firsthit::cli {

struct SceneOptions {
    std::string name;
    LoadSettings load;
};

/// SCENE, --crease-angle, --sphere-segments, --cone-segments
void add_scene_options(CLI::App& app, SceneOptions& options);

/// Reads the scene and prints its warnings to stderr.
/// throws  as load_scene
Scene load(const SceneOptions& options);

} // namespace firsthit::cli
