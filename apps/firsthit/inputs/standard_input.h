// standard_input.h - a scene that comes through standard input.
#pragma once

#include <firsthit/sequence.h>

#include <string>

namespace firsthit::cli {

/// "ply", "stl", "obj" and so on as the ending ".ply". throws  UsageError: says what is accepted
std::string parse_scene_format(const std::string& text);

/// How messages call a scene of standard input: "standard input".
inline constexpr const char* kStandardInput = "standard input";

/// Reads all of standard input as a file with an ending, and the scene in it. The file is kept while the scene is
/// read, under a temporary name that messages do not show.
/// throws  as SceneSequence; FileError: nothing comes in, too much, or there is no place for it
SceneSequence read_standard_input(const std::string& ending, SequenceSettings settings);

} // namespace firsthit::cli
