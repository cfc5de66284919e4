// frame_pattern.h - names of numbered files, as out_%04d.png.
#pragma once

#include <string>

namespace firsthit::cli {

/// A name with one place for a number: %d, %5d or %05d (1 to 9 wide). %% stands for one %.
class FramePattern {
  public:
    /// throws  UsageError where there is no such place, more than one, or another conversion
    explicit FramePattern(const std::string& text);

    /// number  0 or above
    std::string name(int number) const;

  private:
    std::string before_;
    std::string after_;
    std::size_t width_ = 0;
    char fill_ = ' ';
};

/// True where a name has a conversion, whether it is accepted or not.
bool looks_like_pattern(const std::string& text);

} // namespace firsthit::cli
