// report.cpp - what a benchmark found: for the page, for programs, for the terminal.
#include "bench/report/report.h"

#include "bench/report/draw_page.h"
#include "bench/report/report_script.h"
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

std::string write_report(const Report& report, const std::string& folder)
{
    const HoldInterrupts hold;
    const auto path = [&](const std::string& name) {
        return (std::filesystem::path(folder) / name).string();
    };
    for (const auto& [name, bytes] : report.page.files())
        write_file(path(name), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    write_file(path("bench.json"), to_text(report.json));
    const std::string failure = draw_page(folder);
    if (failure.empty()) return "";
    write_file(path("report.py"), report_script().front().text);
    return fmt::format("{} is not written ({}): where there is Python 3, run python3 {} {}",
        path("index.html"), failure, path("report.py"), path("bench.json"));
}

} // namespace firsthit::cli::bench
