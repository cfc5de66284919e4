// baseline.h - `firsthit bench --baseline`: the cpu engine's frames beside Embree's.
#pragma once

#include "bench/bench_options.h"
#include "bench/report/report.h"

namespace firsthit::cli::bench {

/// Measures and adds the chapter: tables and plots to page and text, numbers to json["baseline"].
void add_baseline(const BenchOptions& options, Report& report);

} // namespace firsthit::cli::bench
