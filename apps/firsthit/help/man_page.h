// man_page.h - the manual of the program, as `man` reads it.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace firsthit::cli {

/// firsthit(1): all commands with all their options and examples, in the macros "man" of troff.
std::string man_page(const CLI::App& app);

} // namespace firsthit::cli
