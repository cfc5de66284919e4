// help_page.cpp - the pages of help: of the program, and a short and a full one of each command.
#include "help/help_page.h"

#include "help/basics.h"
#include "help/wrap.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace firsthit::cli {
namespace {

constexpr std::size_t kTextColumn = 24;      // of what options do, in a full page
constexpr std::size_t kShortTextColumn = 22; // in a short one

constexpr const char* kExitCodes = "Exit codes: 0 done, 1 failed, 2 wrong usage.\n";

/// A head and what it means, beside it where that fits.
std::string entry(
    const std::string& head, std::string_view text, std::size_t column, std::size_t columns)
{
    std::string line = "  " + head;
    if (line.size() + 2 > column)
        line += '\n' + std::string(column, ' ');
    else
        line.append(column - line.size(), ' ');
    line.append(text);
    return wrapped(line, columns, column) + '\n';
}

const BasicHelp* basics_of(const std::string& command)
{
    for (const BasicHelp& help : basic_helps())
        if (help.command == command) return &help;
    return nullptr;
}

std::string head_of_page(const CLI::App& command, std::size_t columns)
{
    const BasicHelp* basics = basics_of(command.get_name());
    std::string text = wrapped(
        fmt::format("Usage: firsthit {}\n\n{}.\n\n",
            basics ? std::string(basics->usage) : command.get_name(), command.get_description()),
        columns);
    if (basics) text += fmt::format("Examples:\n{}\n", basics->examples);
    return text;
}

} // namespace

bool is_flag(const CLI::Option& option)
{
    return option.get_expected_max() == 0;
}

std::string option_head(const CLI::Option& option)
{
    if (option.get_positional()) return option.get_name(true);
    std::string head;
    for (const std::string& name : option.get_snames()) head += (head.empty() ? "-" : ", -") + name;
    for (const std::string& name : option.get_lnames())
        head += (head.empty() ? "--" : ", --") + name;
    if (!is_flag(option)) head += " " + option.get_type_name();
    return head;
}

std::string program_help(const CLI::App& app, std::size_t columns)
{
    std::string text =
        wrapped(fmt::format("Usage: firsthit COMMAND ...\n\n{}\n", app.get_description()), columns);
    text += R"(
Examples:
  firsthit render builtin:torus -o torus.png
  firsthit render bunny.stl -o turn.mp4 --turntable 72
  firsthit mask builtin:robots -o masks.json
  firsthit info bunny.stl

Commands:
)";
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        if (!command->get_group().empty())
            text += entry(command->get_name(), command->get_description(), 13, columns);
    text += "\nOptions:\n";
    for (const CLI::Option* option : app.get_options())
        text += entry(option_head(*option), option->get_description(), kShortTextColumn, columns);
    return text + "\n`firsthit COMMAND --help` tells more. " + kExitCodes;
}

std::string short_help(const CLI::App& command, std::size_t columns)
{
    const BasicHelp* basics = basics_of(command.get_name());
    if (!basics) return full_help(command, columns);
    std::string text = head_of_page(command, columns) + "Options:\n";
    for (const BasicOption& basic : basics->options) {
        const CLI::Option* option = command.get_option_no_throw(std::string(basic.name));
        if (!option) continue; // of a build without it
        std::string head = option_head(*option);
        // One long name is enough here, and what is behind NAME=FILE is said beside it.
        const std::size_t second = head.find(", --", head.find("--"));
        if (second != std::string::npos && head.find("--") < second) {
            const std::size_t value = head.find(' ', second + 2);
            head.erase(second, value == std::string::npos ? value : value - second);
        }
        text += entry(head, basic.text, kShortTextColumn, columns);
    }
    return text + wrapped(fmt::format("\nAll options, with what they accept: "
                                      "firsthit {} --help-all\n",
                              command.get_name()),
                      columns);
}

std::string full_help(const CLI::App& command, std::size_t columns)
{
    std::string text = head_of_page(command, columns) + "Options:\n";
    for (const CLI::Option* option : command.get_options())
        if (!option->get_group().empty())
            text += entry(option_head(*option), option->get_description(), kTextColumn, columns);
    std::string more = command.get_footer();
    if (more.starts_with("Examples:")) more.replace(0, 1, "More e"); // than the first ones
    if (!more.empty()) text += '\n' + wrapped(more, columns) + '\n';
    return text;
}

} // namespace firsthit::cli
