// page_server.h - the page of `firsthit view --serve`.
#pragma once

#include "view/view_options.h"

namespace firsthit::cli::view {

/// Serves a page that shows a scene, until SIGINT, SIGTERM or SIGHUP. Prints its address.
/// returns  an exit code
/// throws   Error: the program was built without it (says what to install), the address cannot be had; and as
///          ViewSession
int serve_page(const ViewOptions& options);

} // namespace firsthit::cli::view
