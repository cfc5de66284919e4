// fed_process.h - a program that reads what is written to it, and says why it failed.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace firsthit::cli {

/// Whether a program is found where the environment's PATH says.
bool is_installed(const std::string& program);

/// A child process without a shell. Its standard input is a pipe, its output goes to where ours
/// does, and what it says on standard error is kept. It is in a process group of its own, so that
/// what the terminal interrupts is us, who then end it.
class FedProcess {
  public:
    /// words  the program, looked for in PATH, and its arguments
    /// throws  DeviceError: it cannot be started
    explicit FedProcess(const std::vector<std::string>& words);
    /// Ends it, if it still runs.
    ~FedProcess();
    FedProcess(const FedProcess&) = delete;
    FedProcess& operator=(const FedProcess&) = delete;

    /// Writes to its standard input. False: it reads no more.
    bool write(const void* data, std::size_t bytes);

    /// Ends its input and waits for it.
    /// returns  nothing where it ended with 0; else why it did not: its last words, or its signal
    std::string finish();

  private:
    std::string last_words() const;

    pid_t pid_ = -1;
    int input_ = -1;
    int said_ = -1; // a file without a name
};

} // namespace firsthit::cli
