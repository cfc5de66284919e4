// progress.cpp - a bar on the terminal for long work; nothing in a pipe.
#include "common/progress.h"

#include "common/verbosity.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdint>
#include <utility>

namespace firsthit::cli {

std::string progress_line(const std::string& label, std::size_t done, std::size_t total)
{
    constexpr std::size_t kWidth = 40;
    const std::size_t filled = kWidth * done / total;
    return fmt::format("{} [{}{}] {}/{}", label, std::string(filled, '#'),
        std::string(kWidth - filled, '-'), done, total);
}

std::string progress_rate(std::size_t done, std::size_t total, double seconds)
{
    if (done == 0 || !(seconds > 0)) return {};
    const double rate = double(done) / seconds;
    const double left = std::ceil(double(total - done) / rate);
    // Three digits, and no exponent however slow or fast it is.
    std::string text = fmt::format("  {:.{}f} a second", rate, rate < 10 ? 2 : rate < 100 ? 1 : 0);
    if (left < 60) return text + fmt::format(", {:.0f} s left", left);
    const auto whole = std::uint64_t(std::min(left, 1e9));
    if (whole < 3600) return text + fmt::format(", {}:{:02} min left", whole / 60, whole % 60);
    return text + fmt::format(", {}:{:02} h left", whole / 3600, whole / 60 % 60);
}

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)),
      total_(total),
      visible_(total > 1 && isatty(STDERR_FILENO) && verbosity() != Verbosity::quiet)
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
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    // The line is erased first: what is shorter than before leaves nothing behind.
    std::fprintf(stderr, "\r\033[K%s%s", progress_line(label_, done_, total_).c_str(),
        progress_rate(done_, total_, seconds).c_str());
    std::fflush(stderr);
    drawn_ = std::chrono::steady_clock::now();
}

} // namespace firsthit::cli
