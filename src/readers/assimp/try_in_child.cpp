// try_in_child.cpp - work that may crash, first tried in a process of its own.
#include "readers/assimp/try_in_child.h"

#include <firsthit/error.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <fstream>

namespace firsthit {
namespace {

// A text of 1 MB takes Assimp about 0.1 s and 30 MB. These are ten times that and more.
constexpr std::uint64_t kSeconds = 20;                    // of processor time for the smallest file
constexpr std::uint64_t kBytesPerSecond = 500'000;        // of the file, for one second more
constexpr std::uint64_t kMemory = std::uint64_t(1) << 30; // bytes for the smallest file
constexpr std::uint64_t kMemoryPerByte = 256;             // of the file

constexpr int kOutOfMemory = 3; // the child's exit status

/// Bytes of data that this process has already; the limit is on the sum.
std::uint64_t data_of_process()
{
    std::ifstream file("/proc/self/statm");
    std::uint64_t pages = 0;
    for (int field = 0; field < 6; ++field) file >> pages; // the sixth is data and stack
    return file ? pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

void limit(decltype(RLIMIT_CPU) resource, std::uint64_t most)
{
    rlimit limits{};
    if (getrlimit(resource, &limits) != 0) return;
    if (limits.rlim_max == RLIM_INFINITY || limits.rlim_max > most) limits.rlim_max = most;
    limits.rlim_cur = limits.rlim_max;
    setrlimit(resource, &limits);
}

[[noreturn]] void run_child(
    std::uint64_t seconds, std::uint64_t memory, const std::function<bool()>& work)
{
    const int nowhere = open("/dev/null", O_WRONLY);
    if (nowhere >= 0) {
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
    }
    // Whoever made the parent may handle these; here they end the process.
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGXCPU})
        std::signal(signal, SIG_DFL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, seconds);
    limit(RLIMIT_DATA, memory);
    _exit(work() ? 0 : kOutOfMemory);
}

} // namespace

void try_in_child(const std::string& name, std::size_t bytes, const std::function<bool()>& work)
{
    const std::uint64_t seconds = kSeconds + bytes / kBytesPerSecond;
    const std::uint64_t memory = data_of_process() + kMemory + kMemoryPerByte * bytes;
    const pid_t child = fork();
    if (child < 0) return;
    if (child == 0) run_child(seconds, memory, work);
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return; // somebody else has waited for it
    if (WIFEXITED(status) && WEXITSTATUS(status) == kOutOfMemory)
        throw FileError(fmt::format(
            "{}: cannot be read: it takes Assimp too much memory; is it damaged?", name));
    if (!WIFSIGNALED(status)) return;
    // The limit on processor time ends with SIGXCPU, or SIGKILL where that is the hard one.
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU || signal == SIGKILL)
        throw FileError(fmt::format(
            "{}: cannot be read: it takes Assimp more than {} s; is it damaged?", name, seconds));
    throw FileError(fmt::format(
        "{}: cannot be read: Assimp crashes on it (signal {}); is it damaged?", name, signal));
}

} // namespace firsthit
