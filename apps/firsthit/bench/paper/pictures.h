// pictures.h - the pictures of the paper's figures 2, 4, 7 and 10, and of its scenes.
#pragma once

#include "bench/paper/tables.h"

namespace firsthit::cli::bench {

/// side  pixels of the squares that are rendered
void add_paper_pictures(
    const std::vector<PaperScene>& scenes, int side, int threads, Report& report, Json& json);

} // namespace firsthit::cli::bench
