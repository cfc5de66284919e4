// update_trial.h - which update gives Embree the shortest frames of a scene?
#pragma once

#include "bench/baseline/frames.h"

#include <string>

namespace firsthit::cli::bench {

struct BaselineTrial {
    BaselineUpdate best = BaselineUpdate::refit;
    int packet = 8;           // rays in the widest packets that Embree has instructions for here
    double shortest_ms = 0;   // of the best update's frames, with packets of that size
    std::string failure = {}; // what the DeviceError said that no update was tried for
};

/// Every update that may pay makes a few frames, whole ones; the best has the shortest.
BaselineTrial try_updates(const BaselineScene& scene, const RowSettings& settings);

} // namespace firsthit::cli::bench
