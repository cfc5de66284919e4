// tables.h - the paper's tables 1 to 4, ours beside its.
#pragma once

#include "bench/paper/frames.h"
#include "bench/report/report.h"

#include <vector>

namespace firsthit::cli::bench {

/// Everything that was measured for the tables.
struct PaperMeasured {
    std::vector<PaperScene> scenes;
    std::vector<Way> ways;
    std::vector<std::vector<Frames>> frames; // (scenes, ways); a missing scene has none

    /// Frames of one scene and way; none where the scene is missing.
    const Frames* find(std::size_t scene, const std::string& way) const;
};

/// Adds them to the page and to json, which is that of the paper.
void add_paper_tables(const PaperMeasured& measured, Report& report, Json& json);

} // namespace firsthit::cli::bench
