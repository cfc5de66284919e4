// render_command.h - `firsthit render`: pictures of a scene.
#pragma once

#include "options/render_options.h"

namespace firsthit::cli {

/// returns  an exit code
/// throws   as check and the library
int run_render(const RenderOptions& options);

} // namespace firsthit::cli
