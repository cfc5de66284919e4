// sky_options.h - the light of scenes without lights, and the light of the sky.
#pragma once

#include <firsthit/scene.h>
#include <firsthit/settings.h>

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace firsthit::cli {

/// A number of directions, and a colour.
struct SkyChoice {
    int directions = 0;
    std::optional<glm::vec3> color; // none: by the studio, or grey
};

struct SkyOptions {
    std::optional<bool> studio;   // none: where the scene has no lights of its own
    std::optional<SkyChoice> sky; // none: the studio's, or no sky
    bool draft = false;           // no sky
};

/// "N" or "N,r,g,b". throws  UsageError: the text and what is accepted
SkyChoice parse_sky(const std::string& text);

/// --studio, --sky, --draft
void add_sky_options(CLI::App& app, SkyOptions& options);

/// throws  UsageError: options that exclude one another
/// lights  whether lights are given on the command line
void check(const SkyOptions& options, bool lights);

/// Whether a scene is put into the studio. lights  as for check
bool wants_studio(const SkyOptions& options, const Scene& scene, bool lights);

/// Puts the scene into the studio.
void apply_studio(const SkyOptions& options, Scene& scene);

/// Fills in the settings. studio  whether the scene is in the studio
void apply(const SkyOptions& options, bool studio, Settings& settings);

} // namespace firsthit::cli
