// occlusion_command.h - `firsthit occlusion`: which points do lights not reach?
#pragma once

#include "common/json.h"
#include "options/scene_options.h"

#include <firsthit/scene.h>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace firsthit::cli {

struct OcclusionOptions {
    SceneOptions scene;
    std::string points;
    std::string receivers;     // empty: none
    std::string directions;    // empty: `lights` says all
    std::vector<Light> lights; // in the order of the command line
    std::string output;
    std::optional<double> time_s; // none: the scene's begin
    int threads = 0;
    bool packed = false;
    bool json = false;
    bool stats = false;
};

void add_occlusion_options(CLI::App& app, OcclusionOptions& options);

/// What a run found and how long it took. Milliseconds.
struct OcclusionReport {
    std::uint64_t points = 0, lights = 0, triangles = 0;
    std::uint64_t occluded = 0; // of points * lights
    double load_ms = 0;         // scene, points and directions
    double pose_ms = 0;
    double test_ms = 0;
    double write_ms = 0;
    int threads = 1;
    std::string instruction_set;
};

Json occlusion_json(const OcclusionReport& report);
std::string occlusion_text(const OcclusionReport& report);

/// returns  an exit code
int run_occlusion(const OcclusionOptions& options);

} // namespace firsthit::cli
