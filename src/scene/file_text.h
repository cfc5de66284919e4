// file_text.h - a whole file in memory.
#pragma once

#include <filesystem>
#include <string>

namespace firsthit {

/// The bytes of a regular file of at most 4 GiB.
/// throws  FileError: missing, a folder or device, unreadable, too large (names the file and why)
std::string read_file_text(const std::filesystem::path& path);

} // namespace firsthit
