// peers.h - `firsthit bench --peers`: the cpu engine's frames beside Embree's.
#pragma once

#include "bench/bench_options.h"
#include "bench/report.h"

namespace firsthit::cli::bench {

/// Measures and adds the chapter: tables and plots to page and text, numbers to json["peers"].
void add_peers(const BenchOptions& options, Report& report);

} // namespace firsthit::cli::bench
