// quality.h - what is left out of frames while something moves, so that they come often enough.
#pragma once

#include <firsthit/settings.h>

#include <array>
#include <chrono>
#include <string>
#include <vector>

namespace firsthit::cli::view {

/// One way to make frames: the settings, and what they leave out.
struct Rung {
    Settings settings;
    double scale = 1;    // of the picture's width and height
    std::string missing; // "sky, supersampling"; empty: nothing
};

/// All ways, from whole frames to the quickest: with less of the sky, without it, then without supersampling, then interleaved,
/// then smaller. Steps that leave out nothing are not there.
/// may_interleave  false where the frame cannot be (an environment as background)
std::vector<Rung> rungs_of(const Settings& whole, bool may_interleave);

/// Chooses the way by how long frames took.
class QualityLadder {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// The rung of the next frame, of `count`.
    int rung(int count) const;

    /// Takes note of a frame.
    void made(int rung, double ms, double wanted_ms, int count, Time now);

    /// Forgets all: another scene, size, or other settings.
    void reset();

  private:
    static constexpr int kMost = 16;
    struct Known {
        double ms = 0; // smoothed; 0: not known
        Time when{};
    };
    std::array<Known, kMost> known_{};
    int rung_ = 0;
};

} // namespace firsthit::cli::view
