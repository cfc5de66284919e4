// compare_command.h - `firsthit compare`: holds items and shadows against another ray caster.
#pragma once

#include "camera_options.h"
#include "json.h"
#include "scene_options.h"

#include <firsthit/compare.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace firsthit::cli {

struct CompareOptions {
    SceneOptions scene;
    CameraOptions camera;
    Oracle oracle = Oracle::brute;
    std::optional<double> time_s; // none: the scene's begin
    std::vector<double> frames;   // times; empty: one comparison at time_s
    bool shadows = false;         // compare which lights reach the hits, too
    int threads = 0;
    bool json = false;
};

void add_compare_options(CLI::App& app, CompareOptions& options);

Comparison operator+(const Comparison& a, const Comparison& b);

LitComparison operator+(const LitComparison& a, const LitComparison& b);

/// lit  nothing where shadows were not compared
Json comparison_json(const Comparison& comparison, const std::optional<LitComparison>& lit);
std::string comparison_text(const Comparison& comparison, const std::optional<LitComparison>& lit);

/// returns  an exit code: 0 only where ours is wrong nowhere
int run_compare(const CompareOptions& options);

} // namespace firsthit::cli
