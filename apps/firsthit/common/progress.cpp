// progress.cpp - a bar on the terminal for long work; nothing in a pipe.
#include "common/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace firsthit::cli {

std::string progress_line(const std::string& label, std::size_t done, std::size_t total)
{
    constexpr std::size_t kWidth = 40;
    const std::size_t filled = kWidth * done / total;
    return fmt::format("{} [{}{}] {}/{}", label, std::string(filled, '#'),
        std::string(kWidth - filled, '-'), done, total);
}

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)),
      total_(total),
      visible_(total > 1 && isatty(STDERR_FILENO))
{
    draw();
}

Progress::~Progress()
{
    if (visible_) std::fputs("\r\033[K", stderr);
}

void Progress::advance()
{
    ++done_;
    // Ten times a second are enough for the eye.
    if (std::chrono::steady_clock::now() - drawn_ > std::chrono::milliseconds(100)) draw();
}

void Progress::draw()
{
    if (!visible_) return;
    std::fprintf(stderr, "\r%s", progress_line(label_, done_, total_).c_str());
    std::fflush(stderr);
    drawn_ = std::chrono::steady_clock::now();
}

} // namespace firsthit::cli
