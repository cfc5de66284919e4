// add_parsed.h - adds an option whose text is parsed by a function of ours.
#pragma once

#include "common/usage.h"

#include <functional>
#include <string>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace firsthit::cli {

/// Adds an option whose text goes to `store`. The compiler sees the option parser in one file only.
CLI::Option* add_text_option(CLI::App& app, const std::string& name,
    const std::function<void(const std::string&)>& store, const std::string& type,
    const std::string& help);

/// Adds an option whose text goes through `parse` into `target`; the error names the option.
template <class Target, class Parse>
CLI::Option* add_parsed(CLI::App& app, const std::string& name, Target& target, Parse parse,
    const std::string& type, const std::string& help)
{
    const auto store = [&target, parse, name](const std::string& text) {
        try {
            target = parse(text);
        } catch (const UsageError& error) {
            throw UsageError(name + ": " + error.what());
        }
    };
    return add_text_option(app, name, store, type, help);
}

} // namespace firsthit::cli
