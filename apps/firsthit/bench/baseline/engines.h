// engines.h - our own engines beside each other: threads, and OpenGL.
#pragma once

#include "bench/baseline/scenes.h"
#include "bench/report/report.h"

#include <span>

namespace firsthit::cli::bench {

/// The cpu engine on all threads against one.
void add_threads(std::span<const BaselineScene> scenes, const BenchOptions& options, int threads,
    Report& report, Json& json);

/// The cpu engine against the gpu engine: the same picture, by shadow maps.
void add_gpu(std::span<const BaselineScene> scenes, const BenchOptions& options, int threads,
    Report& report, Json& json);

} // namespace firsthit::cli::bench
