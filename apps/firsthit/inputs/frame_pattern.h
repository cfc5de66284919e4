// frame_pattern.h - names of numbered files, as out_%04d.png.
#pragma once

#include <firsthit/file_pattern.h>

#include <string>

namespace firsthit::cli {

/// The names of the files of frames: see firsthit/file_pattern.h.
class FramePattern {
  public:
    /// throws  UsageError where there is no such place, more than one, or another conversion
    explicit FramePattern(const std::string& text);

    /// number  0 or above
    std::string name(int number) const { return pattern_.name(number); }

  private:
    FilePattern pattern_;
};

/// True where a name has a conversion, whether it is accepted or not.
bool looks_like_pattern(const std::string& text);

} // namespace firsthit::cli
