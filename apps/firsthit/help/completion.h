// completion.h - completion of the command line in shells.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace firsthit::cli {

/// The script that completes firsthit's commands, options, values and files.
/// shell   "bash", "zsh" or "fish"
/// throws  UsageError: another one
std::string completion_script(const CLI::App& app, const std::string& shell);

} // namespace firsthit::cli
