// file.h - files that appear whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace firsthit {

/// Writes a file: under a temporary name beside it, renamed at the end. A link is followed. What
/// exists and is no regular file (/dev/null, a pipe) is written directly.
/// throws  FileError that names the path and the reason; then nothing is left behind
void write_file(const std::string& path, std::string_view bytes);

/// Throws the FileError that writing would meet at once: a folder that is missing or may not be
/// written, a path that is a folder. For asking before a long computation; nothing is created.
void check_output_path(const std::string& path);

} // namespace firsthit
