// completion.cpp - completion of the command line in shells.
#include "help/completion.h"

#include "common/usage.h"
#include "help/help_page.h"
#include "help/suggest.h"

#include <firsthit/film.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace firsthit::cli {
namespace {

/// What an option takes.
struct Values {
    std::vector<std::string> words; // those that are accepted; or
    bool file = false;              // a file
};

bool is_word(const std::string& text)
{
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return ('a' <= c && c <= 'z') || ('0' <= c && c <= '9') || c == '-';
    });
}

Values values_of(const CLI::Option& option)
{
    Values values;
    if (is_flag(option)) return values;
    const std::string type = option.get_type_name();
    if (type == "NAME=FILE") {
        for (int k = 0; k < kAovCount; ++k)
            values.words.push_back(std::string(aov_name(static_cast<Aov>(k))) + "=");
        return values;
    }
    values.file = type.find("FILE") != std::string::npos || option.get_positional();
    for (std::size_t begin = 0; begin <= type.size();) {
        const std::size_t end = std::min(type.find('|', begin), type.size());
        const std::string word = type.substr(begin, end - begin);
        if (type.find('|') != std::string::npos && is_word(word)) values.words.push_back(word);
        begin = end + 1;
    }
    return values;
}

std::vector<const CLI::App*> shown_commands(const CLI::App& app)
{
    std::vector<const CLI::App*> commands;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        if (!command->get_group().empty()) commands.push_back(command);
    return commands;
}

std::vector<std::string> names_of(const CLI::Option& option)
{
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

std::string joined(const std::vector<std::string>& words, const char* separator)
{
    return fmt::format("{}", fmt::join(words, separator));
}

/// The first sentence of a description, without what shells would read.
std::string short_text(const std::string& description)
{
    std::string text = description.substr(0, description.find_first_of(":;"));
    for (char& c : text)
        if (c == '\'' || c == '"' || c == '[' || c == ']' || c == '\\' || c == '`' || c == '$')
            c = ' ';
    return text;
}

std::string bash_values(const CLI::App& command)
{
    std::string text;
    for (const CLI::Option* option : command.get_options()) {
        const Values values = values_of(*option);
        const std::vector<std::string> names = names_of(*option);
        if (names.empty() || is_flag(*option)) continue;
        text += fmt::format("                {}) words=\"{}\"; files={} ;;\n", joined(names, "|"),
            joined(values.words, " "), values.file ? 1 : 0);
    }
    return text;
}

std::string bash_script(const CLI::App& app)
{
    std::string text = fmt::format(R"(# bash completion for firsthit
_firsthit()
{{
    local current=$2 before=$3 command="" words="" files=0 word
    local -a typed=("${{COMP_WORDS[@]:1:COMP_CWORD-1}}")
    for word in "${{typed[@]}}"; do
        case $word in -*) ;; *) command=$word; break ;; esac
    done
    # "name=file": bash splits words at the sign.
    if [[ $current == = ]]; then current=""; files=1; fi
    if [[ $before == = ]]; then files=1; before=""; fi
    case $command in
        "") words="{}" ;;
        help) words="{}" ;;
)",
        joined(command_names(app), " "), joined(command_names(app), " "));
    for (const CLI::App* command : shown_commands(app)) {
        if (command->get_name() == "help") continue;
        text += fmt::format(R"(        {})
            if (( ! files )); then
                case $before in
{}                *) files=1; [[ $current == -* ]] && {{ words="{}"; files=0; }} ;;
                esac
            fi ;;
)",
            command->get_name(), bash_values(*command), joined(long_options(*command), " "));
    }
    return text + R"(    esac
    COMPREPLY=($(compgen -W "$words" -- "$current"))
    if (( files )); then
        compopt -o filenames 2>/dev/null
        COMPREPLY+=($(compgen -f -- "$current"))
    elif [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *= ]]; then
        compopt -o nospace 2>/dev/null
    fi
}
complete -F _firsthit firsthit
)";
}

std::string zsh_value(const CLI::Option& option)
{
    const Values values = values_of(option);
    if (values.file) return ":file:_files";
    if (values.words.empty()) return fmt::format(":{}: ", short_text(option.get_type_name()));
    return fmt::format(":value:({})", joined(values.words, " "));
}

std::string zsh_script(const CLI::App& app)
{
    std::string text = "#compdef firsthit\n# zsh completion for firsthit\n_firsthit()\n{\n"
                       "    local -a commands\n    commands=(\n";
    for (const CLI::App* command : shown_commands(app))
        text += fmt::format(
            "        '{}:{}'\n", command->get_name(), short_text(command->get_description()));
    text += "    )\n    if (( CURRENT == 2 )); then\n        _describe command commands\n"
            "        return\n    fi\n    local command=$words[2]\n    shift words\n"
            "    (( CURRENT -= 1 ))\n    case $command in\n"
            "        help) _describe command commands ;;\n";
    for (const CLI::App* command : shown_commands(app)) {
        if (command->get_name() == "help") continue;
        text += fmt::format("        {})\n            _arguments -s", command->get_name());
        for (const CLI::Option* option : command->get_options())
            for (const std::string& name : names_of(*option))
                text += fmt::format(" \\\n                '*{}[{}]{}'", name,
                    short_text(option->get_description()),
                    is_flag(*option) ? "" : zsh_value(*option));
        text += " \\\n                '*:file:_files' ;;\n";
    }
    return text + "    esac\n}\n_firsthit \"$@\"\n";
}

std::string fish_script(const CLI::App& app)
{
    std::string text = "# fish completion for firsthit\n";
    for (const CLI::App* command : shown_commands(app))
        text += fmt::format("complete -c firsthit -f -n __fish_use_subcommand -a {} -d '{}'\n",
            command->get_name(), short_text(command->get_description()));
    text += fmt::format("complete -c firsthit -f -n '__fish_seen_subcommand_from help' -a '{}'\n",
        joined(command_names(app), " "));
    for (const CLI::App* command : shown_commands(app))
        for (const CLI::Option* option : command->get_options()) {
            if (names_of(*option).empty()) continue;
            text += fmt::format(
                "complete -c firsthit -n '__fish_seen_subcommand_from {}'", command->get_name());
            for (const std::string& name : option->get_snames()) text += " -s " + name;
            for (const std::string& name : option->get_lnames()) text += " -l " + name;
            const Values values = values_of(*option);
            if (!is_flag(*option)) text += values.file ? " -r" : " -x";
            if (!values.words.empty()) text += fmt::format(" -a '{}'", joined(values.words, " "));
            text += fmt::format(" -d '{}'\n", short_text(option->get_description()));
        }
    return text;
}

} // namespace

std::string completion_script(const CLI::App& app, const std::string& shell)
{
    if (shell == "bash") return bash_script(app);
    if (shell == "zsh") return zsh_script(app);
    if (shell == "fish") return fish_script(app);
    throw UsageError(
        fmt::format("'{}' is no shell that is known: accepted are bash, zsh and fish", shell));
}

} // namespace firsthit::cli
