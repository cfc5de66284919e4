// cast_command.h - `firsthit cast`: what do any rays hit?
#pragma once

#include "cast_files.h"
#include "common/json.h"
#include "options/scene_options.h"

#include <cstdint>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace firsthit::cli {

struct CastOptions {
    SceneOptions scene;
    RayFiles files;
    bool any = false, all = false, count = false; // at most one; none: the nearest hit
    std::string output;
    std::optional<double> time_s; // none: the scene's begin
    int threads = 0;
    bool json = false;
    bool stats = false;
};

void add_cast_options(CLI::App& app, CastOptions& options);

/// What a run found and how long it took. Milliseconds.
struct CastReport {
    std::uint64_t rays = 0, triangles = 0;
    std::uint64_t rays_that_hit = 0,
                  hits = 0; // hits: of all triangles with --all and --count, else one a ray
    double load_ms = 0;     // scene and rays
    double pose_ms = 0;
    double build_ms = 0; // the tree over the triangles
    double cast_ms = 0;
    double write_ms = 0;
    int threads = 1;
    std::string instruction_set;
};

Json cast_json(const CastReport& report);
std::string cast_text(const CastReport& report);

/// returns  an exit code
int run_cast(const CastOptions& options);

} // namespace firsthit::cli
