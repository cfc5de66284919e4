// data_options.h - planes in one file, what their ids mean, and which frames are left out.
#pragma once

#include "inputs/frame_part.h"

#include <firsthit/film.h>
#include <firsthit/scene.h>

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace firsthit::cli {

/// What --planes chose for --exr.
struct PlaneChoice {
    bool color = true;
    std::vector<Aov> aovs; // each once
};

struct DataOptions {
    std::string exr;                   // empty: no such file
    std::optional<PlaneChoice> planes; // of it; none: all that the scene has
    std::string manifest;              // empty: none
    bool resume = false;               // frames whose files are there are left out
    FramePart part;                    // frames that are made; none given: all
    bool dry_run = false;              // says what would be rendered
};

/// "color,depth,normal": names of planes, "color" or "all". throws  UsageError
std::optional<PlaneChoice> parse_planes(const std::string& text);

/// --exr, --planes, --manifest, --only, --chunk, --resume, --dry-run
void add_data_options(CLI::App& app, DataOptions& options);

/// All planes that a scene of so many lights has, in frames that are several or not.
PlaneChoice all_planes(std::size_t lights, bool several_frames);

} // namespace firsthit::cli
