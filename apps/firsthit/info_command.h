// info_command.h - `firsthit info`: what is in a scene.
#pragma once

#include "common/json.h"
#include "options/scene_options.h"

#include <firsthit/sequence.h>

#include <string>

namespace CLI {
class App;
}

namespace firsthit::cli {

struct InfoOptions {
    SceneOptions scene;
    bool json = false;
};

void add_info_options(CLI::App& app, InfoOptions& options);

/// What is in a scene whose world is posed.
Json describe(const Scene& scene, const World& world, const std::string& name);

/// What reading all files of a sequence told: {frames, fps, end_s, first, last, triangles, vertices, bounds,
/// new_topology}.
Json describe(SceneSequence& sequence);

/// The same for people.
std::string info_text(const Json& info);

/// returns  an exit code
int run_info(const InfoOptions& options);

} // namespace firsthit::cli
