// track.h - all that moves one node by Kochanek-Bartels splines, as BART's files and the robots have it.
#pragma once

#include <firsthit/animation.h>

#include <string>
#include <utility>
#include <vector>

namespace firsthit {

/// The movement of a node: translation * rotation * scale, where what is missing is the identity.
struct Track {
    std::string name{};                // as the file has it
    std::vector<TcbKey> translation{}; // in order of time
    std::vector<TcbKey> rotation{};    // in order of time
    std::vector<TcbKey> scale{};       // in order of time
    std::vector<std::pair<double, bool>>
        visibility{}; // steps: (time, visible); visible before the first
};

/// Adds a channel to the clip for each property that the track moves.
void add_channels(const Track& track, std::uint32_t node, Clip& clip);

/// Where the track is at a time.
NodeTransform transform_at(const Track& track, double time_s);

} // namespace firsthit
