// switches.cpp - every switch of the viewer by its name.
#include "view/session/switches.h"

#include "common/parse.h"
#include "common/usage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace firsthit::cli::view {

const Switch& switch_named(const std::string& name)
{
    std::vector<std::string> names;
    for (const Switch& one : all_switches()) {
        if (one.name == name) return one;
        names.push_back(one.name);
    }
    throw UsageError(
        fmt::format("there is no switch '{}': accepted are {}", name, fmt::join(names, ", ")));
}

void choose(const Switch& chosen, const std::string& value, ViewState& state)
{
    if (!chosen.words.empty()) {
        if (std::find(chosen.words.begin(), chosen.words.end(), value) == chosen.words.end())
            throw UsageError(fmt::format("{}: '{}' is not accepted: accepted are {}", chosen.name,
                value, fmt::join(chosen.words, ", ")));
        chosen.set(state, value);
        return;
    }
    double number = 0;
    try {
        number = parse_number(value);
    } catch (const UsageError& error) {
        throw UsageError(fmt::format("{}: {}", chosen.name, error.what()));
    }
    if (!(chosen.least <= number && number <= chosen.most) ||
        (chosen.whole && number != std::floor(number)))
        throw UsageError(
            fmt::format("{}: '{}' is not accepted: accepted are {} {} to {}", chosen.name, value,
                chosen.whole ? "whole numbers" : "numbers", chosen.least, chosen.most));
    chosen.set(state, value);
}

bool same_value(const Switch& chosen, const std::string& a, const std::string& b)
{
    if (!chosen.words.empty() || a == b) return a == b;
    const double x = parse_number(a), y = parse_number(b);
    return std::abs(x - y) <= 1e-6 * std::max({1.0, std::abs(x), std::abs(y)});
}

} // namespace firsthit::cli::view
