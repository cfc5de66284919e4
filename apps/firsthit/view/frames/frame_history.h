// frame_history.h - the last frames that were shown: how often they came, and how old the input was by then.
#pragma once

#include "view/frames/frame_request.h"

#include <cstdint>
#include <deque>
#include <vector>

namespace firsthit::cli::view {

/// What is kept of a frame.
struct HistoryEntry {
    Stats stats;
    double made_ms = 0;
    Clock::time_point shown{};
};

class FrameHistory {
  public:
    static constexpr std::size_t kKept = 240; // frames

    /// An event that changed the state to a number.
    void note_input(std::uint64_t number, Clock::time_point when);
    /// A frame has come to the screen.
    void note_shown(const ShownFrame& frame, Clock::time_point when);

    const std::deque<HistoryEntry>& frames() const { return frames_; }
    /// The program looks at its input.
    void note_turn(Clock::time_point when);
    double longest_turn_ms() const { return longest_turn_ms_; }

    /// Frames a second over the last second of frames; 0 where nothing moves.
    double rate(Clock::time_point now) const;
    /// The rate that one frame in a hundred falls below.
    double low_rate() const;

    /// Milliseconds from each event to the screen.
    const std::vector<double>& latencies_ms() const { return latencies_ms_; }
    /// How many frames were shown in all, and the longest time between two of them while something moved.
    std::uint64_t count() const { return count_; }
    double longest_gap_ms() const { return longest_gap_ms_; }
    /// Starts to measure anew.
    void restart();

  private:
    struct Waiting {
        std::uint64_t number = 0;
        Clock::time_point when{};
    };
    std::deque<HistoryEntry> frames_;
    std::deque<Waiting> waiting_;
    std::vector<double> latencies_ms_;
    std::uint64_t count_ = 0;
    double longest_gap_ms_ = 0;
    double longest_turn_ms_ = 0; // between two looks at input
    Clock::time_point last_turn_{};
    bool last_moved_ = false;
};

/// A quantile of some values, 0 to 1; 0 where there are none.
double quantile(std::vector<double> values, double q);

} // namespace firsthit::cli::view
