// paper.h - `firsthit bench --paper`: section 5 of Robert and Schoepke 2006, measured here.
#pragma once

#include "bench/bench_options.h"
#include "bench/report/report.h"

namespace firsthit::cli::bench {

/// Measures and adds the chapter: tables, plots and pictures to page and text, numbers to json["paper"].
/// What needs OpenGL and has none, and a scene that is missing, says so and is left out.
/// throws  as load_scene of the --bart file
///
/// source  Robert, Schoepke 2006, "Interactive Ray Tracing Using Hardware Accelerated Image-Space Methods"
void add_paper(const BenchOptions& options, Report& report);

} // namespace firsthit::cli::bench
