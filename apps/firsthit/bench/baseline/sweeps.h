// sweeps.h - how frame times grow: with triangles, with pixels, with the share that moves.
#pragma once

#include "bench/baseline/frames.h"
#include "bench/report/report.h"

#include <span>

namespace firsthit::cli::bench {

/// Rows that were measured already: waves, in order of their triangles.
void add_triangle_growth(std::span<const BaselineRow> rows, Report& report, Json& json);

/// Measures two scenes at rising sizes.
void add_pixel_growth(
    std::span<const BaselineScene> scenes, const BenchOptions& options, Report& report, Json& json);

/// Measures a cloth of which a rising share of the vertices moves.
void add_moving_shares(const BenchOptions& options, Report& report, Json& json);

} // namespace firsthit::cli::bench
