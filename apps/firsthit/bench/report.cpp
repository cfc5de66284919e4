// report.cpp - what a benchmark found: for the page, for programs, for the terminal.
#include "bench/report.h"

#include "common/interrupt.h"

#include <firsthit/error.h>
#include <firsthit/file.h>

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

namespace firsthit::cli::bench {

ReportFolder::ReportFolder(std::string path) : path_(std::move(path))
{
    if (path_.empty()) return;
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::absolute(path_, error).lexically_normal();
    std::filesystem::path part;
    for (const std::filesystem::path& step : whole) {
        part /= step;
        if (!std::filesystem::exists(part, error)) made_.push_back(part);
    }
    std::filesystem::create_directories(path_, error);
    if (!error) return;
    remove_empty();
    throw FileError(fmt::format("{}: cannot make the folder: {}", path_, error.message()));
}

ReportFolder::~ReportFolder()
{
    remove_empty();
}

void ReportFolder::remove_empty()
{
    // A folder with something in it stays, and those that it is in.
    std::error_code error;
    for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder)
        std::filesystem::remove(*folder, error);
}

void write_report(const Report& report, const std::string& folder)
{
    const HoldInterrupts hold;
    const std::filesystem::path path(folder);
    write_file((path / "bench.json").string(), to_text(report.json));
    write_file((path / "index.html").string(), report.page.html());
}

} // namespace firsthit::cli::bench
