// suggest.h - "did you mean": the known word that is nearest to an unknown one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace firsthit::cli {

/// How many letters have to be added, left out, replaced, or swapped with their neighbours.
std::size_t typing_errors(std::string_view a, std::string_view b);

/// The nearest of the words, where it is near enough to be meant: a third of the letters may be wrong, or
/// the word may be its beginning. Empty: none is.
std::string nearest_word(std::string_view word, const std::vector<std::string>& words);

/// The long options of a command, "--size".
std::vector<std::string> long_options(const CLI::App& command);

/// The names of the commands, but for hidden ones.
std::vector<std::string> command_names(const CLI::App& app);

/// The command of that name, hidden ones too; null: there is none.
const CLI::App* find_command(const CLI::App& app, const std::string& name);

/// "; did you mean --size?" for the first unknown option among the words of a command, or for what other
/// programs call one of ours. Empty: nothing is near.
std::string option_suggestion(const CLI::App& command, const std::vector<std::string>& words);

} // namespace firsthit::cli
