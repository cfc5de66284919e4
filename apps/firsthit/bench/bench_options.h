// bench_options.h - what `firsthit bench` was asked for.
#pragma once

#include "common/parse.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace firsthit::cli::bench {

struct BenchOptions {
    bool paper = false;
    bool baseline = false;
    std::string output; // the page's folder; empty: "report", or none where `json` is given
    std::string json;   // empty: none but the page's; "-": stdout
    std::string bart;   // Robot.aff; empty: builtin:robots
    std::string scenes = "scenes"; // the folder of bunny.stl and dragon.ply
    std::optional<Size> size;
    int threads = 0;
    std::optional<int> rounds;
    bool full = false;  // of --baseline: all sizes and numbers of threads
    bool quick = false; // seconds instead of minutes; says nothing about speed
};

void add_bench_options(CLI::App& app, BenchOptions& options);

/// Finds what cannot work before anything is measured.
/// throws  UsageError: neither --paper nor --baseline
///         DeviceError: frames larger than the machine's memory
///         FileError: a folder or file that cannot be written, a --bart that is not there
void check(const BenchOptions& options);

/// Finds outputs that would replace a file of the scenes.
/// throws  FileError that names both; as load_scene of the --bart file
void check_inputs_stay(const BenchOptions& options);

/// The page's folder; empty: no page.
std::string output_folder(const BenchOptions& options);

/// As asked for, else 1024 x 1024, or small where it is to be quick.
Size size_of(const BenchOptions& options);

/// As asked for, else `usual`, or 2 where it is to be quick.
int rounds_of(const BenchOptions& options, int usual);

/// A fetched scene's file, "scenes/bunny.stl"; empty where it is missing.
std::string fetched_scene(const BenchOptions& options, const std::string& file);

/// The robots: the --bart file, else builtin:robots.
std::string robots_scene(const BenchOptions& options);

} // namespace firsthit::cli::bench
