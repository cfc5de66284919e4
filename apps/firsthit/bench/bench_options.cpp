// bench_options.cpp - what `firsthit bench` was asked for.
#include "bench/bench_options.h"

#include "common/add_parsed.h"
#include "common/usage.h"

#include <firsthit/error.h>
#include <firsthit/file.h>
#include <firsthit/scene.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

namespace firsthit::cli::bench {

namespace {

constexpr const char* kFooter = R"(Examples:
  firsthit bench --paper
  firsthit bench --paper --bart Robot.aff -o report/ --json -
  firsthit bench --baseline --threads 1 -o baseline/
  firsthit bench --paper --quick --json quick.json

The page is DIR/index.html, one file that needs no others; DIR/bench.json has its numbers. Both appear
when all is measured; what was there is replaced. python3 draws the page: where it is missing, the rest is
there, and DIR/report.py, which draws it later. scripts/fetch_scenes.sh fetches bunny and dragon;
BART's Robot.aff (Lext, Assarsson, Moeller 2000) is its users' own, builtin:robots stands in for it.
--baseline takes ten minutes, and counts the pixels in which pictures differ; --full takes an hour.
Other programs that run meanwhile are seen in the numbers. --quick is for trying out the command: its
pictures are small and its numbers say nothing. Exit codes: 0 done, 1 failed, 2 wrong usage.)";

/// The nearest folder that is there.
std::filesystem::path existing_folder(const std::filesystem::path& path)
{
    std::error_code error;
    std::filesystem::path folder = std::filesystem::absolute(path, error);
    while (!std::filesystem::exists(folder, error) && folder.has_parent_path() &&
           folder != folder.parent_path())
        folder = folder.parent_path();
    return folder;
}

void check_readable(const std::string& file)
{
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error) && std::ifstream(file).good()) return;
    throw FileError(fmt::format("--bart: {}: cannot be read as a file", file));
}

// Fourteen kinds of frames keep their memory between their turns: 440 bytes a pixel of all together, measured.
constexpr double kBytesPerPixel = 500;

void check_memory(const Size& size)
{
    const double needed = kBytesPerPixel * size.width * size.height;
    const double memory =
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    if (needed <= memory) return;
    throw DeviceError(
        fmt::format("frames of {}x{} pixels take {:.1f} GB all together, and this machine has "
                    "{:.1f} GB of memory: choose a smaller --size",
            size.width, size.height, needed / 1e9, memory / 1e9));
}

} // namespace

void add_bench_options(CLI::App& app, BenchOptions& options)
{
    app.add_flag("--paper", options.paper,
        "Measure what section 5 of Robert and Schoepke 2006 measures, beside the paper's numbers");
    app.add_flag(
        "--baseline,--peers", options.baseline, "Measure the cpu engine's frames beside Embree's");
    app.add_option("-o,--output", options.output,
           "The page's folder, made where it is missing; default report, or no page with --json")
        ->type_name("DIR");
    app.add_option("--json", options.json, "Write the numbers as JSON; - is standard output")
        ->type_name("FILE");
    app.add_option("--bart", options.bart, "BART's Robot.aff; default builtin:robots in its place")
        ->type_name("PATH");
    app.add_option(
           "--scenes", options.scenes, "The folder of bunny.stl and dragon.ply; default scenes")
        ->type_name("DIR");
    add_parsed(app, "--size", options.size, parse_size, "WxH",
        "Pixels of the frames, each 1 to 65536; default 1024x1024");
    add_parsed(
        app, "--threads", options.threads,
        [](const std::string& text) { return parse_integer(text, 0, 1024); }, "N",
        "Threads, 0 to 1024; default 0: one for each core");
    add_parsed(
        app, "--rounds", options.rounds,
        [](const std::string& text) { return parse_integer(text, 1, 10000); }, "N",
        "Frames of each kind, 1 to 10000, of which the medians are shown");
    app.add_flag("--full", options.full, "Of --baseline: all scenes at all sizes, an hour's work");
    app.add_flag("--quick", options.quick, "Few small frames: tries the command in seconds");
    app.footer(kFooter);
}

void check(const BenchOptions& options)
{
    if (!options.paper && !options.baseline)
        throw UsageError("nothing is asked for: say --paper, --baseline or both");
    check_memory(size_of(options));
    if (!options.bart.empty()) check_readable(options.bart);
    if (const std::string folder = output_folder(options); !folder.empty()) {
        const std::filesystem::path existing = existing_folder(folder);
        if (!std::filesystem::is_directory(existing))
            throw FileError(fmt::format("{}: {} is no folder", folder, existing.string()));
        check_output_path((existing / "index.html").string());
    }
    if (!options.json.empty() && options.json != "-") check_output_path(options.json);
}

void check_inputs_stay(const BenchOptions& options)
{
    std::vector<std::string> inputs;
    if (!options.bart.empty()) inputs = load_scene(options.bart).files;
    for (const char* file : {"bunny.stl", "dragon.ply"})
        if (std::string scene = fetched_scene(options, file); !scene.empty())
            inputs.push_back(std::move(scene));
    std::vector<std::string> outputs;
    if (const std::filesystem::path folder = output_folder(options); !folder.empty())
        for (const char* file : {"bench.json", "index.html"})
            outputs.push_back((folder / file).string());
    if (!options.json.empty() && options.json != "-") outputs.push_back(options.json);
    firsthit::check_inputs_stay(outputs, inputs);
}

std::string output_folder(const BenchOptions& options)
{
    if (!options.output.empty()) return options.output;
    return options.json.empty() ? "report" : "";
}

Size size_of(const BenchOptions& options)
{
    return options.size.value_or(options.quick ? Size{128, 128} : Size{1024, 1024});
}

int rounds_of(const BenchOptions& options, int usual)
{
    return options.rounds.value_or(options.quick ? 2 : usual);
}

std::string fetched_scene(const BenchOptions& options, const std::string& file)
{
    const std::filesystem::path path = std::filesystem::path(options.scenes) / file;
    std::error_code error;
    return std::filesystem::is_regular_file(path, error) ? path.string() : std::string();
}

std::string robots_scene(const BenchOptions& options)
{
    return options.bart.empty() ? "builtin:robots" : options.bart;
}

} // namespace firsthit::cli::bench
