// suggest.cpp - "did you mean": the known word that is nearest to an unknown one.
#include "help/suggest.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace firsthit::cli {
namespace {

/// What other programs call options, and ours.
constexpr auto kOtherNames =
    std::to_array<std::pair<std::string_view, std::string_view>>({{"--resolution", "--size"},
        {"--width", "--size"}, {"--height", "--size"}, {"--res", "--size"}, {"--look-at", "--at"},
        {"--lookat", "--at"}, {"--target", "--at"}, {"--camera-position", "--eye"},
        {"--position", "--eye"}, {"--from", "--eye"}, {"--spp", "--samples"},
        {"--antialiasing", "--samples"}, {"--jobs", "--threads"}, {"--cores", "--threads"},
        {"--animation", "--clip"}, {"--hdri", "--environment"}, {"--envmap", "--environment"},
        {"--layers", "--aov"}, {"--pass", "--aov"}, {"--fov-y", "--fov"},
        {"--orthographic", "--ortho"}, {"--parallel", "--ortho"}, {"--angle", "--fov"},
        {"--silent", "--quiet"}, {"--overwrite", "--resume"}, {"--file", "--output"}});

constexpr std::size_t kLeastBeginning = 3; // letters that stand for a whole word

} // namespace

std::size_t typing_errors(std::string_view a, std::string_view b)
{
    // Rows of the table of distances between beginnings: of two letters before, one, and now.
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t(0));
    for (std::size_t i = 1; i <= a.size(); ++i) {
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool differ = a[i - 1] != b[j - 1];
            now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + differ});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                now[j] = std::min(now[j], before[j - 2] + 1);
        }
        std::swap(before, last);
        std::swap(last, now);
    }
    return last[b.size()];
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& words)
{
    std::string nearest;
    std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string& known : words) {
        const std::size_t errors = typing_errors(word, known);
        if (errors >= least) continue;
        least = errors;
        nearest = known;
    }
    if (!nearest.empty() || word.size() < kLeastBeginning) return nearest;
    for (const std::string& known : words)
        if (known.size() > word.size() && std::string_view(known).substr(0, word.size()) == word)
            return known;
    return {};
}

std::vector<std::string> long_options(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

std::vector<std::string> command_names(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        if (!command->get_group().empty()) names.push_back(command->get_name());
    return names;
}

const CLI::App* find_command(const CLI::App& app, const std::string& name)
{
    const auto found =
        app.get_subcommands([&](const CLI::App* command) { return command->get_name() == name; });
    return found.empty() ? nullptr : found[0];
}

std::string option_suggestion(const CLI::App& command, const std::vector<std::string>& words)
{
    const std::vector<std::string> known = long_options(command);
    for (const std::string& word : words) {
        const std::string name = word.substr(0, word.find('='));
        if (name == "--") break;
        if (name.size() < 4 || name.compare(0, 2, "--") != 0) continue;
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        for (const auto& [other, ours] : kOtherNames)
            if (name == other && std::find(known.begin(), known.end(), ours) != known.end())
                return "; did you mean " + std::string(ours) + "?";
        const std::string nearest = nearest_word(name, known);
        return nearest.empty() ? "" : "; did you mean " + nearest + "?";
    }
    return {};
}

} // namespace firsthit::cli
