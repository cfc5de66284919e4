// usage.h - the error of a command line that cannot be meant.
#pragma once

#include <stdexcept>

namespace firsthit::cli {

/// The program ends with exit code 2.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

inline constexpr int kExitDone = 0;
inline constexpr int kExitFailed = 1;
inline constexpr int kExitUsage = 2;
inline constexpr int kExitNothingToDo = 3; // of render: no frame is left to make

} // namespace firsthit::cli
