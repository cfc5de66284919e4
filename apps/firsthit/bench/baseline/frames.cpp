// frames.cpp - measures one scene's frames by the cpu engine and by Embree, in turn.
#include "bench/baseline/frames.h"

#include "bench/baseline/update_trial.h"
#include "bench/measure/in_turn.h"
#include "common/progress.h"

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

/// A row in the making.
struct Running {
    const BaselineScene& scene;
    BaselineRow row;
    BaselineTrial trial;
    Makers makers;
};

/// Tries Embree's updates, and makes the makers.
Running prepared(const BaselineScene& scene, const RowSettings& settings)
{
    Running running{.scene = scene,
        .row = {.scene = scene.name, .size = settings.size, .threads = settings.threads},
        .trial = {},
        .makers = {}};
    if (!scene.scene) {
        running.row.unavailable = scene.note;
        return running;
    }
    running.row.triangles = scene.scene->triangle_count();
    running.trial = try_updates(scene, settings);
    running.row.update = running.trial.best;
    for (const Side side : {Side::map, Side::exact})
        running.makers[side] =
            our_frames(scene, settings.size, settings.threads, settings_of(side));
    if (!running.trial.failure.empty()) return running;
    const auto embree = [&](int packet) {
        return embree_frames(scene, settings.size, settings.threads, running.row.update, packet);
    };
    running.makers[Side::embree8] = embree(8);
    if (running.trial.packet == 16) running.makers[Side::embree16] = embree(16);
    return running;
}

/// One more frame of each side, with the items, compared with Embree's widest packets.
void compare_pictures(int rounds, Running& running)
{
    for (const auto& [side, maker] : running.makers)
        maker->frame(round_time(running.scene, rounds), true);
    const Film& theirs = running.makers.rbegin()->second->film();
    running.row.exact = difference(running.makers.at(Side::exact)->film(), theirs);
    running.row.map = difference(running.makers.at(Side::map)->film(), theirs);
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

const SideTimes* BaselineRow::find(Side side) const
{
    const auto found = std::find_if(
        sides.begin(), sides.end(), [&](const SideTimes& times) { return times.side == side; });
    return found == sides.end() || found->ms.count == 0 ? nullptr : &*found;
}

Quartiles BaselineRow::ratio(Side ours, Side theirs) const
{
    const SideTimes *a = find(ours), *b = find(theirs);
    return a && b ? ratio_of(b->all_ms, a->all_ms) : Quartiles{};
}

Quartiles BaselineRow::cpu_ratio(Side ours, Side theirs) const
{
    const SideTimes *a = find(ours), *b = find(theirs);
    return a && b ? ratio_of(b->all_cpu_ms, a->all_cpu_ms) : Quartiles{};
}

std::vector<BaselineRow> measure_together(
    std::span<const BaselineScene> scenes, const RowSettings& settings)
{
    std::vector<Running> all;
    std::vector<Contender> contenders;
    double round_ms = 0;
    for (const BaselineScene& scene : scenes) {
        all.push_back(prepared(scene, settings));
        round_ms += all.back().trial.shortest_ms;
        for (const auto& [side, maker] : all.back().makers)
            contenders.push_back(contender(std::string(side_name(side)), scene, *maker));
    }
    const int rounds = rounds_for(settings, round_ms);
    std::vector<Times> times;
    if (!contenders.empty()) {
        Progress progress(
            scenes[0].name, contenders.size() * std::size_t(rounds + FrameMaker::kWarmUp));
        times =
            measure_in_turn(contenders, rounds, FrameMaker::kWarmUp, [&] { progress.advance(); });
    }
    std::vector<BaselineRow> rows;
    std::size_t k = 0;
    for (Running& running : all) {
        BaselineRow& row = running.row;
        row.embree_failure = running.trial.failure;
        for (const auto& [side, maker] : running.makers) {
            if (!times[k].failure.empty()) row.embree_failure = times[k].failure;
            row.sides.push_back({.side = side,
                .ms = quartiles(times[k].ms),
                .cpu_ms = quartiles(maker->cpu_ms()),
                .stages = maker->median_stages(),
                .all_ms = std::move(times[k].ms),
                .all_cpu_ms = maker->cpu_ms()});
            ++k;
        }
        if (settings.pictures && running.scene.scene && row.embree_failure.empty())
            compare_pictures(rounds, running);
        rows.push_back(std::move(row));
    }
    return rows;
}

BaselineRow measure_row(const BaselineScene& scene, const RowSettings& settings)
{
    return measure_together({&scene, 1}, settings).front();
}

} // namespace firsthit::cli::bench
