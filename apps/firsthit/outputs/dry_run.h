// dry_run.h - what `firsthit render --dry-run` says.
#pragma once

#include "options/render_options.h"

#include <string>

namespace firsthit::cli {

/// What would be rendered: scene, pictures, frames, memory and files, a line each.
/// options  with the size, and the planes of --exr, that the scene gave them
std::string dry_run_text(const RenderOptions& options, const Scene& scene, const Frames& frames);

} // namespace firsthit::cli
