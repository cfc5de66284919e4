// report.cpp - what a benchmark found: for the page, for programs, for the terminal.
#include "bench/report.h"

#include "interrupt.h"

#include <firsthit/error.h>
#include <firsthit/file.h>

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace firsthit::cli::bench {

void make_folder(const std::string& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw FileError(fmt::format("{}: cannot make the folder: {}", folder, error.message()));
}

void write_report(const Report& report, const std::string& folder)
{
    const HoldInterrupts hold;
    const std::filesystem::path path(folder);
    write_file((path / "bench.json").string(), to_text(report.json));
    write_file((path / "index.html").string(), report.page.html());
}

} // namespace firsthit::cli::bench
