// ground_options.cpp - a floor under the model.
#include "options/ground_options.h"

#include "common/parse.h"
#include "common/usage.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace firsthit::cli {
namespace {

glm::vec3 parse_ground_color(const std::string& text)
{
    const UsageError wrong(
        fmt::format("--ground: '{}' is no colour: accepted are R,G,B, linear, each 0 to 1, "
                    "or nothing (a name of a scene stands before --ground)",
            text));
    glm::dvec3 color;
    try {
        color = parse_vector(text);
    } catch (const UsageError&) {
        throw wrong;
    }
    if (std::min({color.x, color.y, color.z}) < 0 || std::max({color.x, color.y, color.z}) > 1)
        throw wrong;
    return glm::vec3(color);
}

} // namespace

void add_ground_option(CLI::App& app, GroundOptions& options)
{
    app.add_option_function<std::vector<std::string>>(
           "--ground",
           [&options](const std::vector<std::string>& texts) {
               options.wanted = true;
               if (!texts.empty() && !texts[0].empty())
                   options.color = parse_ground_color(texts[0]);
           },
           "A floor under the model, which catches its shadow: of a linear colour, or one that "
           "looks as the "
           "background where nothing shadows it")
        ->type_name("[R,G,B]")
        ->expected(0, 1);
}

} // namespace firsthit::cli
