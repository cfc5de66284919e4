// fed_process.cpp - a program that reads what is written to it, and says why it failed.
#include "films/fed_process.h"

#include <firsthit/error.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <system_error>

namespace firsthit::cli {
namespace {

constexpr std::size_t kMostWords = 600; // bytes of what a program said that an error repeats

[[noreturn]] void throw_not_started(const std::string& program, int error)
{
    throw DeviceError(
        fmt::format("cannot start {}: {}", program, std::generic_category().message(error)));
}

/// What a child is given, for posix_spawn.
struct SpawnSettings {
    posix_spawn_file_actions_t files{};
    posix_spawnattr_t attributes{};

    SpawnSettings(int input, int said)
    {
        posix_spawn_file_actions_init(&files);
        posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&files, said, STDERR_FILENO);
        posix_spawnattr_init(&attributes);
        sigset_t usual;
        sigemptyset(&usual);
        for (const int signal : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM, SIGHUP})
            sigaddset(&usual, signal);
        posix_spawnattr_setsigdefault(&attributes, &usual);
        posix_spawnattr_setpgroup(&attributes, 0);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    }
    ~SpawnSettings()
    {
        posix_spawn_file_actions_destroy(&files);
        posix_spawnattr_destroy(&attributes);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;
};

} // namespace

bool is_installed(const std::string& program)
{
    const char* path = std::getenv("PATH");
    std::string_view folders = path ? path : "/usr/local/bin:/usr/bin:/bin";
    for (;;) {
        const std::size_t end = folders.find(':');
        const std::string folder(folders.substr(0, end));
        const std::string file = (folder.empty() ? "." : folder) + "/" + program;
        if (access(file.c_str(), X_OK) == 0) return true;
        if (end == std::string_view::npos) return false;
        folders.remove_prefix(end + 1);
    }
}

FedProcess::FedProcess(const std::vector<std::string>& words)
{
    std::array<int, 2> ends{};
    said_ = memfd_create("said", MFD_CLOEXEC);
    if (said_ < 0 || pipe2(ends.data(), O_CLOEXEC) != 0) {
        const int error = errno;
        if (said_ >= 0) close(said_);
        throw_not_started(words[0], error);
    }
    input_ = ends[1];
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const SpawnSettings settings(ends[0], said_);
    const int error = posix_spawnp(
        &pid_, words[0].c_str(), &settings.files, &settings.attributes, arguments.data(), environ);
    close(ends[0]);
    if (error == 0) return;
    close(input_);
    close(said_);
    throw_not_started(words[0], error);
}

FedProcess::~FedProcess()
{
    if (input_ >= 0) close(input_);
    if (pid_ > 0) {
        kill(pid_, SIGKILL);
        while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    close(said_);
}

bool FedProcess::write(const void* data, std::size_t bytes)
{
    const char* rest = static_cast<const char*>(data);
    while (bytes > 0) {
        const ssize_t written = ::write(input_, rest, bytes);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        rest += written;
        bytes -= std::size_t(written);
    }
    return true;
}

std::string FedProcess::finish()
{
    close(input_);
    input_ = -1;
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
    const std::string said = last_words();
    if (WIFSIGNALED(status))
        return fmt::format("it was ended by signal {} ({}){}{}", WTERMSIG(status),
            strsignal(WTERMSIG(status)), said.empty() ? "" : ": ", said);
    return said.empty() ? fmt::format("it ended with exit code {}", WEXITSTATUS(status)) : said;
}

std::string FedProcess::last_words() const
{
    const off_t end = lseek(said_, 0, SEEK_END);
    if (end <= 0) return {};
    const std::size_t count = std::min(kMostWords, std::size_t(end));
    std::string text(count, ' ');
    const ssize_t got = pread(said_, text.data(), count, end - off_t(count));
    text.resize(got > 0 ? std::size_t(got) : 0);
    // A beginning that was cut off is left out.
    if (std::size_t(end) > count && text.find('\n') != std::string::npos)
        text.erase(0, text.find('\n') + 1);
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
    return text;
}

} // namespace firsthit::cli
