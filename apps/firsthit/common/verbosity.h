// verbosity.h - how much the program says beside its results: --quiet, --verbose.
#pragma once

#include <string>

namespace firsthit::cli {

enum class Verbosity {
    quiet,   // errors alone
    usual,   // warnings and bars of progress too
    verbose, // what is done, too
};

/// Of this process; usual until it is set.
Verbosity verbosity();
void set_verbosity(Verbosity verbosity);

/// "firsthit: ..." on stderr, where --verbose was said.
void print_detail(const std::string& text);

} // namespace firsthit::cli
