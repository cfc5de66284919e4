// add_parsed.cpp - adds an option whose text is parsed by a function of ours.
#include "common/add_parsed.h"

#include <CLI/CLI.hpp>

namespace firsthit::cli {

CLI::Option* add_text_option(CLI::App& app, const std::string& name,
    const std::function<void(const std::string&)>& store, const std::string& type,
    const std::string& help)
{
    return app.add_option_function<std::string>(name, store, help)->type_name(type);
}

} // namespace firsthit::cli
