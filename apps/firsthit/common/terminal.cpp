// terminal.cpp - what the terminal that we write to can show.
#include "common/terminal.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace firsthit::cli {
namespace {

/// no-color.org: set and not empty means none.
bool shows_colors()
{
    const char* none = std::getenv("NO_COLOR");
    const char* terminal = std::getenv("TERM");
    return !(none && *none) && terminal && std::string_view(terminal) != "dumb" &&
           isatty(STDERR_FILENO);
}

std::string colored(const std::string& text, int color)
{
    return shows_colors() ? fmt::format("\033[1;{}m{}\033[0m", color, text) : text;
}

} // namespace

int text_columns()
{
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return std::clamp(int(size.ws_col), 40, 100);
}

std::string in_error_color(const std::string& text)
{
    return colored(text, 31);
}

std::string in_warning_color(const std::string& text)
{
    return colored(text, 33);
}

} // namespace firsthit::cli
