// program.h - the commands of the program, their options, and their help.
#pragma once

#include <memory>

namespace CLI {
class App;
}

namespace firsthit::cli {

/// The whole command line: which commands there are, and what each runs.
class Program {
  public:
    Program();
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    /// Does what the words ask for.
    /// returns  an exit code
    /// throws   UsageError: words that are not accepted; the message says what may be meant and where help
    ///          is. And as the commands
    int run(int argc, const char* const* argv);

    /// What parses the words.
    const CLI::App& app() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace firsthit::cli
