// file.h - writes files that appear whole or not at all, and protects input files from being
// overwritten.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace firsthit {

/// Writes a file under a temporary name in the same folder and renames it at the end. A file that
/// is replaced keeps its permissions. A symbolic link is followed, even if its target does not
/// exist yet. If the path exists but is not a regular file (/dev/null, a pipe), it is written
/// directly. "-" is standard output.
/// throws  FileError, with the path and the reason; no temporary file is left
void write_file(const std::string& path, std::string_view bytes);

/// Checks, before a long computation, whether a file can be written. Creates nothing.
/// throws  FileError: the folder does not exist or is not writable, or the path is a folder
void check_output_path(const std::string& path);

/// The file that a write to `path` would write: a canonical path that is the same for all
/// spellings, with symbolic links followed, even a last one whose target does not exist yet.
/// Returns `path` itself if there is no such path.
std::string output_target(const std::string& path);

/// Whether both paths lead to the same file, also through symbolic and hard links. For files that
/// do not exist yet: whether writing both would write the same file.
bool same_file(const std::string& a, const std::string& b);

/// Checks, before anything is written, that no output would replace an input. Compares files as
/// same_file does.
/// inputs  for example Scene::files
/// throws  FileError for the first output that would replace an input; the message names both
void check_inputs_stay(std::span<const std::string> outputs, std::span<const std::string> inputs);

} // namespace firsthit
