// draw_page.cpp - has Python draw the report's page.
#include "bench/report/draw_page.h"

#include "bench/report/report_script.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

namespace firsthit::cli::bench {

namespace {

std::string reason(int error)
{
    return std::generic_category().message(error);
}

/// Starts python3 with the file as its standard input. returns  0, or the error's number
int spawn_python(std::FILE* script, const std::string& json, pid_t& child)
{
    // -I: of the folder where we are and of the user's settings nothing is imported; -: the script is read
    // from standard input.
    std::array<std::string, 4> words = {"python3", "-I", "-", json};
    const std::array<char*, 5> arguments = {
        words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
    sigset_t held;
    sigemptyset(&held);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&held, signal);

    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_adddup2(&actions, fileno(script), STDIN_FILENO);
    posix_spawnattr_setsigmask(&attributes, &held);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    const int error =
        posix_spawnp(&child, "python3", &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

} // namespace

std::string draw_page(const std::string& folder)
{
    // A file, not a pipe: a Python that does not read it all hurts nobody.
    const std::string_view text = report_script().front().text;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> script(std::tmpfile(), std::fclose);
    if (!script || std::fwrite(text.data(), 1, text.size(), script.get()) != text.size() ||
        std::fflush(script.get()) != 0 || std::fseek(script.get(), 0, SEEK_SET) != 0)
        return "no temporary file: " + reason(errno);

    // An absolute path is no option, whatever the folder's name begins with.
    const std::filesystem::path json = std::filesystem::absolute(folder) / "bench.json";
    pid_t child = 0;
    if (const int error = spawn_python(script.get(), json.string(), child))
        return "python3: " + reason(error);
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return "python3: " + reason(errno);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
    return WIFEXITED(status) ? fmt::format("python3 exits with {}", WEXITSTATUS(status))
                             : fmt::format("python3 is ended by signal {}", WTERMSIG(status));
}

} // namespace firsthit::cli::bench
