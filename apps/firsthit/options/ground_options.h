// ground_options.h - a floor under the model.
#pragma once

#include <glm/vec3.hpp>

#include <optional>

namespace CLI {
class App;
}

namespace firsthit::cli {

struct GroundOptions {
    bool wanted = false;
    std::optional<glm::vec3> color; // none: looks as the background where nothing shadows it
};

/// --ground
void add_ground_option(CLI::App& app, GroundOptions& options);

} // namespace firsthit::cli
