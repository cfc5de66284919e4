// peer_trial.cpp - which update gives Embree the shortest frames of a scene?
#include "bench/peer_trial.h"

#include "stopwatch.h"

#include <firsthit/error.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace firsthit::cli::bench {

namespace {

constexpr int kFrames = 3;      // kept of each update; the shortest counts
constexpr double kHopeless = 3; // times the best frame: no more frames are made

/// The updates that may be best. Spatial splits take seconds: they pay where the tree is kept.
std::vector<PeerUpdate> candidates(const PeerScene& scene)
{
    const bool kept = scene.kept && !scene.moves();
    if (kept) return {PeerUpdate::rebuild_medium, PeerUpdate::rebuild_high};
    std::vector<PeerUpdate> updates{
        PeerUpdate::refit, PeerUpdate::rebuild_low, PeerUpdate::rebuild_medium};
    if (scene.scene->parts.size() > 1) updates.push_back(PeerUpdate::refit_parts);
    return updates;
}

/// The shortest of a few frames, after the one that builds the tree.
double shortest_frame_ms(const PeerScene& scene, const RowSettings& settings, PeerUpdate update,
    double best_ms, int& packet)
{
    EmbreePeer peer(*scene.scene, update, settings.threads);
    packet = peer.packet();
    Settings shadows;
    shadows.shadows = Shadows::exact;
    Film film;
    double shortest = std::numeric_limits<double>::infinity();
    for (int frame = -1; frame < kFrames; ++frame) {
        const Stopwatch watch;
        const double cpu_begin = process_cpu_ms();
        const World& world = peer.pose(scene.time_s + (frame + 1) * kFrameTime_s);
        if (!scene.kept) peer.assume_moved();
        peer.render(scene.view(world, settings.size), shadows, film);
        if (frame < 0) continue;
        // Of one thread, the processor's time is less disturbed by other programs.
        const double ms = settings.threads == 1 ? process_cpu_ms() - cpu_begin : watch.ms();
        shortest = std::min(shortest, ms);
        if (shortest > kHopeless * best_ms) break;
    }
    return shortest;
}

} // namespace

PeerTrial try_updates(const PeerScene& scene, const RowSettings& settings)
{
    PeerTrial trial;
    double best_ms = std::numeric_limits<double>::infinity();
    try {
        for (const PeerUpdate update : candidates(scene)) {
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
