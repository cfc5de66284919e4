// quality.cpp - what is left out of frames while something moves.
#include "view/frames/quality.h"

#include <fmt/format.h>

#include <algorithm>

namespace firsthit::cli::view {
namespace {

/// As many directions still tell light from dark.
constexpr int kFewDirections = 5;
/// A frame of a rung is tried again after this long, when what was known of it may be old.
constexpr std::chrono::seconds kStale{3};
/// What a frame may take longer than wanted before a lower rung is taken: machines are noisy.
constexpr double kTooLong = 1.15;
/// A rung whose time is not known is tried where the one below takes less than this share of what is wanted.
constexpr double kRoom = 0.6;

void add_rung(std::vector<Rung>& rungs, const char* left_out)
{
    Rung next = rungs.back();
    if (!next.missing.empty()) next.missing += ", ";
    next.missing += left_out;
    rungs.push_back(next);
}

} // namespace

std::vector<Rung> rungs_of(const Settings& whole, bool may_interleave)
{
    std::vector<Rung> rungs(1);
    rungs[0].settings = whole;
    if (whole.sky.directions > kFewDirections) {
        add_rung(rungs, "most of the sky");
        rungs.back().settings.sky.directions = kFewDirections;
    }
    if (whole.sky.directions > 0) {
        rungs.push_back({.settings = rungs.back().settings, .missing = "sky"});
        rungs.back().settings.sky.directions = 0;
    }
    if (whole.samples > 1 || whole.adaptive > 1) {
        add_rung(rungs, "supersampling");
        rungs.back().settings.samples = 1;
        rungs.back().settings.adaptive = 1;
    }
    const std::string before = rungs.back().missing;
    for (const int n : {2, 4}) {
        if (!may_interleave || whole.interleave >= n) continue;
        Rung next = rungs.back();
        next.settings.interleave = n;
        next.missing =
            before + fmt::format("{}{} of {} rays", before.empty() ? "" : ", ", n - 1, n);
        rungs.push_back(next);
    }
    for (const double scale : {0.7, 0.5, 0.35, 0.25}) {
        Rung next = rungs.back();
        next.scale = scale;
        next.settings.interleave = std::max(1, whole.interleave); // size does it alone
        next.missing = before + (before.empty() ? "pixels" : ", pixels");
        rungs.push_back(next);
    }
    return rungs;
}

int QualityLadder::rung(int count) const
{
    return std::min(rung_, count - 1);
}

void QualityLadder::made(int rung, double ms, double wanted_ms, int count, Time now)
{
    Known& known = known_[std::size_t(std::min(rung, kMost - 1))];
    known.ms = known.ms == 0 || now - known.when > kStale ? ms : 0.6 * known.ms + 0.4 * ms;
    known.when = now;
    if (rung != this->rung(count)) return; // of an earlier choice
    if (known.ms > kTooLong * wanted_ms && rung + 1 < count) {
        rung_ = rung + 1;
        return;
    }
    if (rung == 0) return;
    const Known& above = known_[std::size_t(std::min(rung - 1, kMost - 1))];
    const bool told = above.ms > 0 && now - above.when < kStale;
    if (told ? above.ms < wanted_ms : known.ms < kRoom * wanted_ms) rung_ = rung - 1;
}

void QualityLadder::reset()
{
    *this = {};
}

} // namespace firsthit::cli::view
