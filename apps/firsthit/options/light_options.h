// light_options.h - which lights shine on the scene, and how their shadows are found.
#pragma once

#include "inputs/parse_light.h"

#include <firsthit/render.h>
#include <firsthit/scene.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace firsthit::cli {

struct LightOptions {
    std::vector<Light> lights;     // empty: the scene's own
    std::vector<std::size_t> suns; // of these, the ones that were given for a world with y up
    Shadows shadows = Shadows::automatic;
    std::optional<int> shadow_map_size;
    std::optional<double> shadow_bias;
    std::optional<int> shadow_filter;
};

/// "none", "map" or "exact". throws  UsageError
Shadows parse_shadows(const std::string& text);

/// --light
void add_light_option(CLI::App& app, LightOptions& options);

/// --light, --shadows, --shadow-map-size, --shadow-bias, --shadow-filter
void add_light_options(CLI::App& app, LightOptions& options);

/// throws  UsageError: an option of shadow maps where the engine will not make them
void check(const LightOptions& options, Engine engine = Engine::cpu);

/// Turns the suns into a world with another axis up; once.
void turn_suns(const glm::dvec3& up_axis, LightOptions& options);

/// Replaces the scene's lights where some were given.
void apply(const LightOptions& options, Scene& scene);

/// Fills in the settings of shadows.
void apply(const LightOptions& options, Settings& settings);

} // namespace firsthit::cli
