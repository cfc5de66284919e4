// occlusion_command.h - `firsthit occlusion`: which points do lights not reach?
#pragma once

#include "common/json.h"
#include "options/scene_options.h"
#include "inputs/sun_span.h"

#include <firsthit/scene.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace firsthit::cli {

struct OcclusionOptions {
    SceneOptions scene;
    std::string points;
    std::string receivers;         // empty: none
    std::string directions;        // empty: `lights` says all
    std::vector<Light> lights;     // in the order of the command line
    std::vector<std::size_t> suns; // of these, the ones that were given for a world with y up
    std::optional<SunSpan> sun;    // of --sun
    bool hours = false;            // of it: sums in the place of answers
    double north_deg = 0;
    std::optional<glm::dvec3> up_axis; // none: by the kind of file
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
    std::uint64_t nights = 0;   // of the lights: suns below the horizon, which are not tested
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
