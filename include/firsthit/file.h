// file.h - files that appear whole or not at all, and never in place of what was read.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace firsthit {

/// Writes a file: under a temporary name beside it, renamed at the end. A file that is replaced
/// keeps its permissions. A symbolic link is followed, also to a file that is not there yet. What
/// exists and is no regular file (/dev/null, a pipe) is written directly.
/// throws  FileError that names the path and the reason; then nothing is left behind
void write_file(const std::string& path, std::string_view bytes);

/// Throws the FileError that writing would meet at once: a folder that is missing or may not be
/// written, a path that is a folder. For asking before a long computation; nothing is created.
void check_output_path(const std::string& path);

/// Where a write to `path` ends: one name for all the ways to spell it, symbolic links followed, also
/// a last one that leads to nothing yet. `path` itself where there is no such name.
std::string output_target(const std::string& path);

/// True where both paths lead to one file, through symbolic and hard links too; of files that do not
/// exist yet, where writes to both would make one file.
bool same_file(const std::string& a, const std::string& b);

/// Throws the FileError of the first of `outputs` whose writing would replace one of `inputs`, such
/// as Scene::files; it names both. For asking before anything is written. Files are told apart as by
/// same_file.
void check_inputs_stay(std::span<const std::string> outputs, std::span<const std::string> inputs);

} // namespace firsthit
