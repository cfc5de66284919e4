// mask_command.h - `firsthit mask`: masks of what is seen, for data sets.
#pragma once

#include "options/picture_set_options.h"

#include <firsthit/film.h>

#include <string>

namespace CLI {
class App;
}

namespace firsthit::cli {

struct MaskOptions : PictureSetOptions {
    Aov kind = Aov::instance;
    std::string output; // "-": standard output
    std::string picture = "picture.png";
    bool compressed = true;
    bool visibility = true;
};

void add_mask_options(CLI::App& app, MaskOptions& options);

/// Finds what cannot work before the scene is loaded. After read_files.
/// throws  UsageError, FileError
void check(const MaskOptions& options);

/// returns  an exit code
/// throws   as check and the library
int run_mask(const MaskOptions& options);

} // namespace firsthit::cli
