// interrupt.h - lets a file be finished before the program is stopped.
#pragma once

#include <array>
#include <csignal>

namespace firsthit::cli {

/// While it lives, SIGINT, SIGTERM and SIGHUP wait. They are raised at its end. For writing: a file
/// is then whole or absent, and no temporary name stays behind. One at a time.
class HoldInterrupts {
  public:
    HoldInterrupts();
    ~HoldInterrupts();
    HoldInterrupts(const HoldInterrupts&) = delete;
    HoldInterrupts& operator=(const HoldInterrupts&) = delete;

  private:
    std::array<struct sigaction, 3> before_{};
};

} // namespace firsthit::cli
