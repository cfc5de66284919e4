// basics.h - what most people need of each command: the first screen of its help.
#pragma once

#include <span>
#include <string_view>

namespace firsthit::cli {

/// An option as the first screen tells it: its long name, or a word for a positional one, and one
/// short line.
struct BasicOption {
    std::string_view name; // "--size", or "SCENE"
    std::string_view text;
};

/// The first screen of a command's help.
struct BasicHelp {
    std::string_view command;
    std::string_view usage;    // after "firsthit "
    std::string_view examples; // a line each
    std::span<const BasicOption> options;
};

/// Of all commands that have options; the order is that of the program's own help.
std::span<const BasicHelp> basic_helps();

} // namespace firsthit::cli
