// pose_options.h - which clip, camera and time of a scene.
#pragma once

#include <firsthit/scene.h>

#include <string>

namespace CLI {
class App;
}

namespace firsthit::cli {

struct PoseOptions {
    std::string clip;   // a name, a number, or "none"; empty: the first
    std::string camera; // a name or a number; empty: the first
};

/// --clip, --camera
void add_pose_options(CLI::App& app, PoseOptions& options);

/// The clip and camera of a scene, at the time where the clip begins. A name counts before a number.
/// throws  ArgumentError: there is no such clip or camera; says which there are
PoseSettings pose_settings(const PoseOptions& options, const Scene& scene);

} // namespace firsthit::cli
