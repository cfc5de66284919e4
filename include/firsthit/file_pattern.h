// file_pattern.h - names of numbered files, such as frames/%04d.obj.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace firsthit {

/// A path with one place for a number: %d, %5d or %05d (1 to 9 wide; filled up with spaces or zeros;
/// longer numbers are not cut). %% stands for one %. Nothing else after a % is accepted.
class FilePattern {
  public:
    static constexpr int kMaxNumber = 999'999'999; // of existing(): nine digits

    /// throws  ArgumentError: there is no such place, more than one, or another conversion
    explicit FilePattern(std::string text);

    /// The path with a number in its place.
    /// number  0 or above
    std::string name(int number) const;

    /// The numbers of the regular files whose paths are name(number), ascending.
    /// throws  FileError: the folder cannot be listed
    std::vector<int> existing() const;

    /// As it was given to the constructor.
    const std::string& text() const { return text_; }

  private:
    std::string text_;
    std::string before_;
    std::string after_;
    std::size_t width_ = 0;
    char fill_ = ' ';
};

} // namespace firsthit
