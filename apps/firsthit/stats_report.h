// stats_report.h - where the time went, as a table and as JSON.
#pragma once

#include "common/json.h"

#include <firsthit/render.h>

#include <cstdint>
#include <string>
#include <vector>

namespace firsthit::cli {

struct FrameReport {
    double time_s = 0; // of the scene
    Stats stats;
};

/// What a run of `render` measured.
struct RunReport {
    std::string scene;
    int width = 0;
    int height = 0;
    int samples = 1;  // N of N x N
    int adaptive = 1; // the same where there are edges
    int threads = 1;
    std::string instruction_set;
    std::string engine = "cpu"; // that made the last frame
    std::string device;         // of OpenGL, or empty
    double load_ms = 0;
    std::uint64_t peak_memory_bytes = 0; // of the process
    std::vector<FrameReport> frames;     // at least one
};

/// Milliseconds by stage and counts; of several frames the mean and the largest. Rows of zeros are left out.
std::string stats_table(const RunReport& report);

/// The same with every frame.
Json stats_json(const RunReport& report);

/// Peak memory of this process so far.
std::uint64_t peak_memory_bytes();

} // namespace firsthit::cli
