// light_options.h - which lights shine on the scene, and how their shadows are found.
#pragma once

#include <firsthit/render.h>
#include <firsthit/scene.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace firsthit::cli {

struct LightOptions {
    std::vector<Light> lights; // empty: the scene's own
    Shadows shadows = Shadows::automatic;
    std::optional<int> shadow_map_size;
    std::optional<double> shadow_bias;
    std::optional<int> shadow_filter;
};

/// "point:x,y,z", "spot:x,y,z,dx,dy,dz,DEG[,INNER]" or "directional:dx,dy,dz"; angles are full.
/// throws  UsageError: the text and what is accepted
Light parse_light(const std::string& text);

/// "none", "map" or "exact". throws  UsageError
Shadows parse_shadows(const std::string& text);

/// --light, --shadows, --shadow-map-size, --shadow-bias, --shadow-filter
void add_light_options(CLI::App& app, LightOptions& options);

/// throws  UsageError: an option of shadow maps where the engine will not make them
void check(const LightOptions& options, Engine engine = Engine::cpu);

/// Replaces the scene's lights where some were given.
void apply(const LightOptions& options, Scene& scene);

/// Fills in the settings of shadows.
void apply(const LightOptions& options, Settings& settings);

} // namespace firsthit::cli
