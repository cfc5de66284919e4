// view_command.h - `firsthit view`: a window to look at a scene, and at how its picture is made.
#pragma once

#include "view/view_options.h"

namespace firsthit::cli {

/// returns  an exit code
/// throws   as check and the library; Error: no display, a window that cannot be made, an assertion
int run_view(const ViewOptions& options);

} // namespace firsthit::cli
