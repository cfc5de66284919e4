// help_test.cpp - pages of help, suggestions, completions and the manual.
#include "help/basics.h"
#include "help/completion.h"
#include "help/help_page.h"
#include "help/man_page.h"
#include "help/program.h"
#include "help/suggest.h"
#include "help/wrap.h"

#include "common/usage.h"
#include "message_of.h"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace firsthit::cli {
namespace {

std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::vector<const CLI::App*> commands_of(const Program& program)
{
    return program.app().get_subcommands([](const CLI::App*) { return true; });
}

TEST(Help, TheFirstPageIsOneScreen)
{
    const Program program;
    for (const std::size_t columns : {80u, 100u}) {
        EXPECT_LE(lines_of(program_help(program.app(), columns)).size(), 50u);
        for (const CLI::App* command : commands_of(program)) {
            const auto lines = lines_of(short_help(*command, columns));
            EXPECT_LE(lines.size(), 50u) << command->get_name();
            for (const std::string& line : lines) EXPECT_LE(line.size(), columns) << line;
        }
    }
}

TEST(Help, WhatIsToldIsThere)
{
    const Program program;
    for (const BasicHelp& help : basic_helps()) {
        const CLI::App* command = find_command(program.app(), std::string(help.command));
        ASSERT_NE(command, nullptr) << help.command;
        for (const BasicOption& option : help.options)
            EXPECT_NE(command->get_option_no_throw(std::string(option.name)), nullptr)
                << help.command << ' ' << option.name;
        for (const std::string& line : lines_of(std::string(help.examples)))
            EXPECT_EQ(line.rfind("  firsthit " + std::string(help.command) + ' ', 0), 0u) << line;
    }
}

TEST(Help, TheFullPageHasAllOptions)
{
    const Program program;
    for (const CLI::App* command : commands_of(program)) {
        const std::string page = full_help(*command, 80);
        for (const std::string& name : long_options(*command))
            EXPECT_NE(page.find(name), std::string::npos) << command->get_name() << ' ' << name;
        for (const std::string& line : lines_of(page)) EXPECT_LE(line.size(), 80u) << line;
    }
}

TEST(Help, LinesAreWrappedAtSpacesAndKeepTheirWords)
{
    EXPECT_EQ(wrapped("one two three", 7), "one two\nthree");
    EXPECT_EQ(wrapped("  one two three", 8), "  one\n  two\n  three");
    EXPECT_EQ(wrapped("a\n\nb", 10), "a\n\nb");
    EXPECT_EQ(wrapped("aaaaaaaaaaaa", 5), "aaaaaaaaaaaa");
    EXPECT_EQ(wrapped("", 5), "");
    EXPECT_EQ(wrapped("  -o FILE  one two three four", 21, 11),
        "  -o FILE  one two\n           three four");
}

TEST(Suggest, TypingErrorsAreCounted)
{
    EXPECT_EQ(typing_errors("size", "size"), 0u);
    EXPECT_EQ(typing_errors("siez", "size"), 1u); // swapped
    EXPECT_EQ(typing_errors("sze", "size"), 1u);
    EXPECT_EQ(typing_errors("sizes", "size"), 1u);
    EXPECT_EQ(typing_errors("sise", "size"), 1u);
    EXPECT_EQ(typing_errors("", "size"), 4u);
    EXPECT_EQ(typing_errors("kitten", "sitting"), 3u);
}

TEST(Suggest, TheNearestWordIsMeantWhereItIsNear)
{
    const std::vector<std::string> words = {"render", "info", "compare"};
    EXPECT_EQ(nearest_word("rendr", words), "render");
    EXPECT_EQ(nearest_word("comp", words), "compare");
    EXPECT_EQ(nearest_word("xyzzy", words), "");
    EXPECT_EQ(nearest_word("", words), "");
}

std::string usage_of(std::vector<const char*> words)
{
    words.insert(words.begin(), "firsthit");
    Program program;
    return message_of<UsageError>([&] { program.run(int(words.size()), words.data()); });
}

TEST(Suggest, UnknownWordsGetASuggestion)
{
    EXPECT_NE(usage_of({"rendr"}).find("did you mean render?"), std::string::npos);
    EXPECT_NE(usage_of({"render", "s", "--sampels", "3"}).find("did you mean --samples?"),
        std::string::npos);
    EXPECT_NE(usage_of({"render", "s", "--resolution=9x9"}).find("did you mean --size?"),
        std::string::npos);
    EXPECT_EQ(usage_of({"render", "s", "--xyzzy"}).find("did you mean"), std::string::npos);
    EXPECT_NE(usage_of({"help", "inof"}).find("did you mean info?"), std::string::npos);
    EXPECT_NE(usage_of({"completion", "tcsh"}).find("bash, zsh and fish"), std::string::npos);
}

TEST(Completion, HasEveryCommandAndOption)
{
    const Program program;
    for (const char* shell : {"bash", "zsh", "fish"}) {
        const std::string script = completion_script(program.app(), shell);
        for (const CLI::App* command : commands_of(program)) {
            if (command->get_group().empty()) continue;
            EXPECT_NE(script.find(command->get_name()), std::string::npos) << shell;
            for (const std::string& name : long_options(*command))
                EXPECT_NE(script.find(name.substr(2)), std::string::npos) << shell << ' ' << name;
        }
        EXPECT_NE(script.find("hybrid"), std::string::npos) << shell; // a value
        EXPECT_EQ(script.find("completion bash "), std::string::npos) << shell;
    }
}

TEST(ManPage, HasEveryCommandAndOption)
{
    const Program program;
    const std::string page = man_page(program.app());
    for (const CLI::App* command : commands_of(program)) {
        if (command->get_group().empty() || command->get_name() == "help") continue;
        EXPECT_NE(page.find(".SH \"FIRSTHIT " + command->get_name()), std::string::npos);
        for (std::string name : long_options(*command)) {
            for (std::size_t at = 0; (at = name.find('-', at)) != std::string::npos; at += 2)
                name.insert(at, "\\");
            EXPECT_NE(page.find(name), std::string::npos) << name;
        }
    }
}

} // namespace
} // namespace firsthit::cli
