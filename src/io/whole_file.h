// whole_file.h - a whole file in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace firsthit {

/// The bytes of a regular file.
///
/// max_bytes  a larger file is an error, so that a wrong name cannot fill the memory
/// throws     FileError: missing, a folder or device, unreadable, too large (names the file and
/// why)
std::string read_whole_file(
    const std::filesystem::path& path, std::uintmax_t max_bytes = std::uintmax_t(1) << 32);

/// Adds the path of a file that is about to be read to those that a scene was read from
/// (Scene::files). Nothing where there is no such file.
void add_file(const std::filesystem::path& path, std::vector<std::string>& files);

} // namespace firsthit
