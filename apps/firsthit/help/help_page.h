// help_page.h - the pages of help: of the program, and a short and a full one of each command.
#pragma once

#include <cstddef>
#include <string>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace firsthit::cli {

/// The program's: its commands.
std::string program_help(const CLI::App& app, std::size_t columns);

/// One screen: examples, and the options that most people need.
std::string short_help(const CLI::App& command, std::size_t columns);

/// All options, and all that there is to say.
std::string full_help(const CLI::App& command, std::size_t columns);

/// "-o, --output FILE": an option's names and what it takes.
std::string option_head(const CLI::Option& option);

/// Whether an option takes no value.
bool is_flag(const CLI::Option& option);

} // namespace firsthit::cli
