// progress.h - a bar on the terminal for long work; nothing in a pipe.
#pragma once

#include <chrono>
#include <string>

namespace firsthit::cli {

/// Draws on stderr where that is a terminal, unless --quiet was said. The line is erased at the end of its life, so that
/// errors and results start on a clean one.
class Progress {
  public:
    /// total  steps, at least 1; a bar of one step is never drawn
    Progress(std::string label, std::size_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// One more step is done.
    void advance();

  private:
    void draw();

    std::string label_;
    std::size_t total_;
    std::size_t done_ = 0;
    bool visible_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::chrono::steady_clock::time_point drawn_{};
};

/// "frames [#####---------------]  5/20"
std::string progress_line(const std::string& label, std::size_t done, std::size_t total);

/// "  3.2 a second, 1:07 left": what follows it once something is done. Empty before.
/// seconds  since the start
std::string progress_rate(std::size_t done, std::size_t total, double seconds);

} // namespace firsthit::cli
