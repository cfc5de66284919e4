// draw_page.h - has Python draw the report's page.
#pragma once

#include <string>

namespace firsthit::cli::bench {

/// Runs tools/report.py, whose text is in the program: DIR/bench.json and its pictures become
/// DIR/index.html, whole or not at all. Signals that stop the program do not stop Python.
/// returns  why there is no page, as where python3 is missing; empty: it is there
std::string draw_page(const std::string& folder);

} // namespace firsthit::cli::bench
