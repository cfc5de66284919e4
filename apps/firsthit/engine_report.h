// engine_report.h - how far an engine agrees with the cpu engine, as a table and as JSON.
#pragma once

#include "common/json.h"

#include <firsthit/compare.h>

#include <string>

namespace firsthit::cli {

/// device  OpenGL's renderer and version
Json engine_comparison_json(const EngineComparison& comparison, const std::string& device);
std::string engine_comparison_text(const EngineComparison& comparison, const std::string& device);

} // namespace firsthit::cli
