// window.h - the window of `firsthit view`.
#pragma once

#include "view/script/script_player.h"
#include "view/view_options.h"

namespace firsthit::cli::view {

/// Shows a scene until the window is closed or the script ends.
/// script   or null
/// returns  an exit code
/// throws   Error: the program was built without a window (says what to install), there is no display, OpenGL
///          3.3 is missing; and as ViewSession and ScriptPlayer
int show_window(const ViewOptions& options, ScriptPlayer* script);

} // namespace firsthit::cli::view
