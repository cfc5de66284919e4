// whole_file.h - a whole file in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace firsthit {

/// The bytes of a regular file.
///
/// max_bytes  a larger file is an error, so that a wrong name cannot fill the memory
/// throws     FileError: missing, a folder or device, unreadable, too large (names the file and
/// why)
std::string read_whole_file(
    const std::filesystem::path& path, std::uintmax_t max_bytes = std::uintmax_t(1) << 32);

} // namespace firsthit
