// figures.h - the paper's figures 8 and 9: where the time goes, and how it varies.
#pragma once

#include "bench/paper/tables.h"

namespace firsthit::cli::bench {

/// Figure 8, from the robots' frames of the tables.
void add_time_shares(const PaperMeasured& measured, Report& report, Json& json);

/// The ways whose frames figure 9 shows.
std::vector<Way> animation_ways();

/// Figure 9.
/// frames  (ways) of animation_ways, gone through several times with so many rounds
void add_animation(const PaperScene& robots, const std::vector<Frames>& frames, int rounds,
    Report& report, Json& json);

} // namespace firsthit::cli::bench
