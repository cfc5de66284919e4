// frame_part.h - which frames of a run this process makes: --only and --chunk.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace firsthit::cli {

/// The number-th of `count` parts, from 1.
struct Chunk {
    int number = 1;
    int count = 1;
};

/// Nothing given: all frames.
struct FramePart {
    std::vector<int> only; // numbers of frames, ascending; empty: all
    std::optional<Chunk> chunk;

    /// Whether frames may be left out.
    bool any() const { return !only.empty() || chunk.has_value(); }
};

/// "I/N" with 1 <= I <= N <= a million. throws  UsageError
Chunk parse_chunk(const std::string& text);

/// --only, --chunk
void add_frame_part_options(CLI::App& app, FramePart& part);

/// Which frames belong to the part: of those that `only` names, a contiguous run. The parts of all numbers
/// together have every such frame once; their sizes differ by at most one.
///
/// number   of each frame, ascending
/// returns  (frames)
std::vector<bool> frames_in_part(const FramePart& part, const std::vector<int>& number);

} // namespace firsthit::cli
