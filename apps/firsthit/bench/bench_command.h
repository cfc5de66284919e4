// bench_command.h - `firsthit bench`: how fast, beside the paper's numbers and other ray casters.
#pragma once

#include "bench/bench_options.h"

namespace firsthit::cli::bench {

/// Measures, then writes page and JSON, and prints the tables unless JSON goes to standard output.
/// returns  an exit code
int run_bench(const BenchOptions& options);

} // namespace firsthit::cli::bench
