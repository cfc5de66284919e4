// man_page.cpp - the manual of the program, as `man` reads it.
#include "help/man_page.h"

#include "help/basics.h"
#include "help/help_page.h"

#include <firsthit/render.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <string_view>

namespace firsthit::cli {
namespace {

/// Text in which troff finds no commands. Hyphens are those of options, which can be copied.
std::string escaped(std::string_view text)
{
    std::string result;
    bool begins = true; // a line
    for (const char c : text) {
        if (begins && (c == '.' || c == '\'')) result += "\\&";
        begins = c == '\n';
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else
            result += c;
    }
    return result;
}

/// Lines that stay as they are.
std::string verbatim(std::string_view text)
{
    std::string result = ".nf\n" + escaped(text);
    if (result.back() != '\n') result += '\n';
    return result + ".fi\n";
}

std::string manual_of(const CLI::App& command)
{
    std::string usage = command.get_name(), examples;
    for (const BasicHelp& help : basic_helps()) {
        if (help.command != command.get_name()) continue;
        usage = help.usage;
        examples = help.examples;
    }
    std::string text = fmt::format(".SH \"FIRSTHIT {}\"\n.B firsthit {}\n.PP\n{}.\n",
        command.get_name(), escaped(usage), escaped(command.get_description()));
    if (!examples.empty()) text += ".PP\nExamples:\n" + verbatim(examples);
    for (const CLI::Option* option : command.get_options())
        if (!option->get_group().empty())
            text += fmt::format(".TP\n.B {}\n{}\n", escaped(option_head(*option)),
                escaped(option->get_description()));
    if (!command.get_footer().empty()) text += ".PP\n" + verbatim(command.get_footer());
    return text;
}

} // namespace

std::string man_page(const CLI::App& app)
{
    std::string text = fmt::format(
        ".TH FIRSTHIT 1 \"\" \"firsthit {}\" \"User Commands\"\n.SH NAME\nfirsthit \\- "
        "ray\\-traced "
        "pictures of triangle scenes, exact to the pixel\n.SH SYNOPSIS\n.B firsthit\n.I COMMAND\n"
        "[\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n{}\n.SH COMMANDS\n",
        version(), escaped(app.get_description()));
    const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
    for (const CLI::App* command : commands)
        if (!command->get_group().empty())
            text += fmt::format(".TP\n.B {}\n{}\n", escaped(command->get_name()),
                escaped(command->get_description()));
    text += ".SH OPTIONS\n";
    for (const CLI::Option* option : app.get_options())
        text += fmt::format(
            ".TP\n.B {}\n{}\n", escaped(option_head(*option)), escaped(option->get_description()));
    for (const CLI::App* command : commands)
        if (!command->get_group().empty() && command->get_name() != "help")
            text += manual_of(*command);
    return text + R"(.SH "EXIT STATUS"
0 done, 1 failed, 2 wrong usage.
.SH ENVIRONMENT
.TP
.B FIRSTHIT_ISA
AVX3, AVX2, SSE4 or SCALAR: a lower instruction set. Results stay the same.
.TP
.B NO_COLOR
Set and not empty: errors and warnings have no colours.
)";
}

} // namespace firsthit::cli
