// view_options.h - what `firsthit view` was asked for.
#pragma once

#include "options/render_options.h"
#include "view/serve/listen_address.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace firsthit::cli {

struct ViewOptions {
    RenderOptions picture;   // the picture at rest, by the options of `render`
    double rate = 60;        // frames a second to hold while something moves
    double fps_limit = 0;    // most frames a second that are shown; 0: as the screen does
    std::string script;      // actions; empty: none
    std::string screenshot;  // of the window, at the end of the script
    bool no_window = false;  // plays the script without a window
    bool measure = false;    // prints times from input to the screen at the end
    bool size_given = false; // by --size
    std::optional<view::ListenAddress> serve{}; // a page in the place of a window
};

void add_view_options(CLI::App& app, ViewOptions& options);

/// Finds what cannot work before the scene is loaded.
/// throws  UsageError; FileError
void check(ViewOptions& options);

} // namespace firsthit::cli
