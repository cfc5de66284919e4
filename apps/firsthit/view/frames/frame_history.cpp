// frame_history.cpp - the last frames that were shown.
#include "view/frames/frame_history.h"

#include <algorithm>
#include <cmath>

namespace firsthit::cli::view {
namespace {

/// Most values that are kept of a measurement: an hour of input.
constexpr std::size_t kMostLatencies = 1'000'000;
/// Most events that wait for their frame: where frames fail, none comes.
constexpr std::size_t kMostWaiting = 10'000;
/// Frames further apart than this do not belong to one motion.
constexpr double kPauseMs = 500;

double ms_between(Clock::time_point a, Clock::time_point b)
{
    return std::chrono::duration<double, std::milli>(b - a).count();
}

} // namespace

void FrameHistory::note_input(std::uint64_t number, Clock::time_point when)
{
    if (waiting_.size() < kMostWaiting) waiting_.push_back({number, when});
}

void FrameHistory::note_turn(Clock::time_point when)
{
    if (last_turn_ != Clock::time_point{})
        longest_turn_ms_ = std::max(longest_turn_ms_, ms_between(last_turn_, when));
    last_turn_ = when;
}

void FrameHistory::note_shown(const ShownFrame& frame, Clock::time_point when)
{
    while (!waiting_.empty() && waiting_.front().number <= frame.request.number) {
        if (latencies_ms_.size() < kMostLatencies)
            latencies_ms_.push_back(ms_between(waiting_.front().when, when));
        waiting_.pop_front();
    }
    if (!frames_.empty() && last_moved_ && frame.request.moving)
        longest_gap_ms_ = std::max(longest_gap_ms_, ms_between(frames_.back().shown, when));
    last_moved_ = frame.request.moving;
    ++count_;
    frames_.push_back({frame.stats, frame.made_ms, when});
    if (frames_.size() > kKept) frames_.pop_front();
}

double FrameHistory::rate(Clock::time_point now) const
{
    int count = 0;
    double first_ms = 0;
    for (auto at = frames_.rbegin(); at != frames_.rend(); ++at) {
        const double ago = ms_between(at->shown, now);
        if (ago > 1000) break;
        first_ms = ago;
        ++count;
    }
    return count < 2 ? 0 : 1000 * (count - 1) / std::max(1e-3, first_ms);
}

double FrameHistory::low_rate() const
{
    std::vector<double> gaps;
    for (std::size_t k = 1; k < frames_.size(); ++k) {
        const double gap = ms_between(frames_[k - 1].shown, frames_[k].shown);
        if (gap < kPauseMs) gaps.push_back(gap);
    }
    const double slow = quantile(gaps, 0.99);
    return slow > 0 ? 1000 / slow : 0;
}

void FrameHistory::restart()
{
    *this = {};
}

double quantile(std::vector<double> values, double q)
{
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const double at = q * double(values.size() - 1);
    return values[std::size_t(std::llround(at))];
}

} // namespace firsthit::cli::view
