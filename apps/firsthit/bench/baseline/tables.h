// tables.h - what was measured beside Embree, as tables and as JSON.
#pragma once

#include "bench/baseline/frames.h"
#include "bench/report/report.h"

#include <span>
#include <string>

namespace firsthit::cli::bench {

/// Frames of all scenes, of one size and number of threads: milliseconds, ratios, pictures.
void add_frames_tables(std::span<const BaselineRow> rows, const std::string& title, Report& report);

/// Where the time goes, by each side's stages.
void add_stages_table(std::span<const BaselineRow> rows, Report& report);

/// How many times faster than Embree we are asked to be, and are.
void add_asked_table(std::span<const BaselineScene> scenes, std::span<const BaselineRow> rows,
    Report& report, Json& json);

Json row_json(const BaselineRow& row);

} // namespace firsthit::cli::bench
