// peer_frames.cpp - measures one scene's frames by the cpu engine and by Embree, in turn.
#include "bench/peer_frames.h"

#include "bench/in_turn.h"
#include "bench/peer_trial.h"
#include "progress.h"

#include <algorithm>
#include <map>
#include <memory>

namespace firsthit::cli::bench {

namespace {

constexpr double kSlow_ms = 8000; // a side's rounds together, before there are fewer of them
constexpr int kFewest = 5;

Settings settings_of(Side side)
{
    Settings settings;
    settings.shadows = side == Side::map ? Shadows::map : Shadows::exact;
    return settings;
}

Quartiles ratio_of(const std::vector<double>& theirs, const std::vector<double>& ours)
{
    std::vector<double> ratios;
    for (std::size_t k = 0; k < std::min(theirs.size(), ours.size()); ++k)
        if (ours[k] > 0) ratios.push_back(theirs[k] / ours[k]);
    return quartiles(std::move(ratios));
}

/// As many rounds as the frames leave time for.
int rounds_for(const RowSettings& settings, double frame_ms)
{
    if (!settings.fewer || frame_ms <= 0) return settings.rounds;
    const double fit = std::min(kSlow_ms / frame_ms, 1e6);
    return std::min(settings.rounds, std::max(kFewest, int(fit)));
}

using Makers = std::map<Side, std::unique_ptr<FrameMaker>>;

/// One more frame of each side, with the items, compared with Embree's widest packets.
void compare_pictures(const Makers& makers, double time_s, PeerRow& row)
{
    for (const auto& [side, maker] : makers) maker->frame(time_s, true);
    const Film& theirs = makers.rbegin()->second->film();
    row.exact = difference(makers.at(Side::exact)->film(), theirs);
    row.map = difference(makers.at(Side::map)->film(), theirs);
}

} // namespace

std::string_view side_name(Side side)
{
    switch (side) {
    case Side::map:
        return "ours, map";
    case Side::exact:
        return "ours, exact";
    case Side::embree8:
        return "Embree, 8 rays";
    case Side::embree16:
        return "Embree, 16 rays";
    }
    return "";
}

const SideTimes* PeerRow::find(Side side) const
{
    const auto found = std::find_if(
        sides.begin(), sides.end(), [&](const SideTimes& times) { return times.side == side; });
    return found == sides.end() || found->ms.count == 0 ? nullptr : &*found;
}

Quartiles PeerRow::ratio(Side ours, Side theirs) const
{
    const SideTimes *a = find(ours), *b = find(theirs);
    return a && b ? ratio_of(b->all_ms, a->all_ms) : Quartiles{};
}

Quartiles PeerRow::cpu_ratio(Side ours, Side theirs) const
{
    const SideTimes *a = find(ours), *b = find(theirs);
    return a && b ? ratio_of(b->all_cpu_ms, a->all_cpu_ms) : Quartiles{};
}

PeerRow measure_row(const PeerScene& scene, const RowSettings& settings)
{
    PeerRow row{.scene = scene.name, .size = settings.size, .threads = settings.threads};
    if (!scene.scene) {
        row.unavailable = scene.note;
        return row;
    }
    row.triangles = scene.scene->triangle_count();
    const PeerTrial trial = try_updates(scene, settings);
    row.update = trial.best;

    Makers makers;
    for (const Side side : {Side::map, Side::exact})
        makers[side] = our_frames(scene, settings.size, settings.threads, settings_of(side));
    if (trial.failure.empty()) {
        const auto embree = [&](int packet) {
            return embree_frames(scene, settings.size, settings.threads, trial.best, packet);
        };
        makers[Side::embree8] = embree(8);
        if (trial.packet == 16) makers[Side::embree16] = embree(16);
    }
    std::vector<Contender> contenders;
    for (const auto& [side, maker] : makers)
        contenders.push_back(contender(std::string(side_name(side)), scene, *maker));
    const int rounds = rounds_for(settings, trial.shortest_ms);
    Progress progress(scene.name, contenders.size() * std::size_t(rounds + FrameMaker::kWarmUp));
    std::vector<Times> times =
        measure_in_turn(contenders, rounds, FrameMaker::kWarmUp, [&] { progress.advance(); });
    std::string failure = trial.failure;
    std::size_t k = 0;
    for (const auto& [side, maker] : makers) {
        if (!times[k].failure.empty()) failure = times[k].failure;
        row.sides.push_back({.side = side,
            .ms = quartiles(times[k].ms),
            .cpu_ms = quartiles(maker->cpu_ms()),
            .stages = maker->median_stages(),
            .all_ms = std::move(times[k].ms),
            .all_cpu_ms = maker->cpu_ms()});
        ++k;
    }
    row.embree_failure = failure;
    if (settings.pictures && failure.empty())
        compare_pictures(makers, round_time(scene, rounds), row);
    return row;
}

} // namespace firsthit::cli::bench
