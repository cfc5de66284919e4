// report_script.h - the text of tools/report.py, put into the program by the build.
#pragma once

#include <span>
#include <string_view>

namespace firsthit::cli::bench {

struct Script {
    std::string_view name; // from the root of the sources: "tools/report.py"
    std::string_view text;
};

/// Only the one.
std::span<const Script> report_script();

} // namespace firsthit::cli::bench
