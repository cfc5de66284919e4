// in_turn.h - measures several ways to do the same thing, frame by frame in turn.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace firsthit::cli::bench {

/// One of the ways. Rounds before 0 warm up: programs are compiled, memory grows, nothing is kept.
struct Contender {
    std::string name;
    std::function<double(int round)>
        frame; // makes a frame; returns its milliseconds, as it times them
};

/// What a contender took.
struct Times {
    std::vector<double> ms; // (rounds)
    std::string failure;    // why it has none: what the DeviceError said that stopped it
};

/// Every contender makes the frame of a round before any makes that of the next; each round begins with
/// another, so that what disturbs the machine disturbs all alike. A contender that throws DeviceError (no
/// OpenGL, no Embree) is left out from then on; other errors pass.
///
/// rounds  at least 1;  warm_up  rounds before these, numbered -warm_up to -1
/// done    called after each frame, may be empty
/// returns (contenders), in their order
std::vector<Times> measure_in_turn(const std::vector<Contender>& contenders, int rounds,
    int warm_up, const std::function<void()>& done = {});

} // namespace firsthit::cli::bench
