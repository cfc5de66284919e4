// join_command.h - `firsthit join`: pictures of regions become the whole picture.
#pragma once

#include "common/parse.h"

#include <firsthit/join.h>

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace firsthit::cli {

struct JoinOptions {
    std::vector<PictureTile> tiles;
    std::string output;
    std::optional<Size> size; // that they have to cover; none: as far as they reach
};

/// "x,y,width,height=FILE". throws  UsageError
PictureTile parse_tile(const std::string& text);

void add_join_options(CLI::App& app, JoinOptions& options);

/// returns  an exit code
int run_join(const JoinOptions& options);

} // namespace firsthit::cli
