// file_bytes.h - a whole file in memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace firsthit {

/// Reads a whole regular file.
///
/// max_size  bytes; a larger file is an error, so that a wrong name cannot fill the memory
/// throws    FileError: missing, a folder or a device, unreadable, larger than max_size
std::string read_bytes(
    const std::filesystem::path& path, std::size_t max_size = std::size_t(1) << 36);

} // namespace firsthit
