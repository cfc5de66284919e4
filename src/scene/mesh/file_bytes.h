// file_bytes.h - a whole file in memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace firsthit {

/// Assimp counts bytes with 32 bits.
inline constexpr std::size_t kMaxMeshFile = 0xFFFFFFFF;

/// Reads a whole regular file.
///
/// max_size  bytes; a larger file is an error, so that a wrong name cannot fill the memory
/// throws    FileError: missing, a folder or a device, unreadable, larger than max_size
std::string read_bytes(const std::filesystem::path& path, std::size_t max_size = kMaxMeshFile);

} // namespace firsthit
