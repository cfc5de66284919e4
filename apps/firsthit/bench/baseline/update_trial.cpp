// update_trial.cpp - which update gives Embree the shortest frames of a scene?
#include "bench/baseline/update_trial.h"

#include "common/stopwatch.h"

#include <firsthit/error.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace firsthit::cli::bench {

namespace {

constexpr int kFrames = 3;      // kept of each update; the shortest counts
constexpr double kHopeless = 3; // times the best frame: no more frames are made

/// The updates that may be best. Spatial splits take seconds: they pay where the tree is kept.
std::vector<BaselineUpdate> candidates(const BaselineScene& scene)
{
    const bool kept = scene.kept && !scene.moves();
    if (kept) return {BaselineUpdate::rebuild_medium, BaselineUpdate::rebuild_high};
    std::vector<BaselineUpdate> updates{
        BaselineUpdate::refit, BaselineUpdate::rebuild_low, BaselineUpdate::rebuild_medium};
    if (scene.scene->instances.size() > 1) updates.push_back(BaselineUpdate::refit_instances);
    return updates;
}

/// The shortest of a few frames, after the one that builds the tree.
double shortest_frame_ms(const BaselineScene& scene, const RowSettings& settings,
    BaselineUpdate update, double best_ms, int& packet)
{
    EmbreeBaseline baseline(scene.scene, update, settings.threads);
    packet = baseline.packet();
    Settings shadows;
    shadows.shadows = Shadows::exact;
    Film film;
    double shortest = std::numeric_limits<double>::infinity();
    for (int frame = -1; frame < kFrames; ++frame) {
        const Stopwatch watch;
        const double cpu_begin = process_cpu_ms();
        const World& world = baseline.pose(scene.time_s + (frame + 1) * kFrameTime_s);
        if (!scene.kept) baseline.assume_moved();
        baseline.render(scene.view(world, settings.size), shadows, film);
        if (frame < 0) continue;
        // Of one thread, the processor's time is less disturbed by other programs.
        const double ms = settings.threads == 1 ? process_cpu_ms() - cpu_begin : watch.ms();
        shortest = std::min(shortest, ms);
        if (shortest > kHopeless * best_ms) break;
    }
    return shortest;
}

} // namespace

BaselineTrial try_updates(const BaselineScene& scene, const RowSettings& settings)
{
    BaselineTrial trial;
    double best_ms = std::numeric_limits<double>::infinity();
    try {
        for (const BaselineUpdate update : candidates(scene)) {
            const double ms = shortest_frame_ms(scene, settings, update, best_ms, trial.packet);
            if (ms >= best_ms) continue;
            best_ms = ms;
            trial.best = update;
        }
        trial.shortest_ms = best_ms;
    } catch (const DeviceError& error) {
        trial.failure = error.what();
    }
    return trial;
}

} // namespace firsthit::cli::bench
