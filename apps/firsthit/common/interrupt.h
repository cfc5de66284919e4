// interrupt.h - lets a file be finished before the program is stopped.
#pragma once

#include <array>
#include <csignal>

namespace firsthit::cli {

/// While it lives, SIGINT, SIGTERM and SIGHUP wait. They are raised at its end. For writing: a file
/// is then whole or absent, and no temporary name stays behind. They may be nested: the outermost
/// one decides.
class HoldInterrupts {
  public:
    HoldInterrupts();
    ~HoldInterrupts();
    /// Whether a signal waits: long work may end early.
    static bool is_pending();

    HoldInterrupts(const HoldInterrupts&) = delete;
    HoldInterrupts& operator=(const HoldInterrupts&) = delete;

  private:
    std::array<struct sigaction, 3> before_{};
};

/// Lets a write beyond the limit on the size of files (ulimit -f), and one to a pipe that nobody reads,
/// fail as other writes do: with a message and without a file left under its temporary name. The default
/// is to end the program.
void survive_failing_writes();

/// Ends the program as one that writes to a closed pipe ends.
[[noreturn]] void end_by_closed_pipe();

} // namespace firsthit::cli
