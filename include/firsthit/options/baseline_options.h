// baseline_options.h - options and statistics of the Embree baseline.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace firsthit {

/// How Embree's tree is updated for a frame. If nothing has moved since the last frame, the tree is
/// not changed.
enum class BaselineUpdate {
    refit_instances, // a tree for each scene instance, refitted if it has moved, and one over all instances
    refit,           // one tree of medium quality, refitted
    rebuild_low,    // one tree, rebuilt quickly along a Morton curve (RTC_BUILD_QUALITY_LOW)
    rebuild_medium, // one tree, rebuilt (RTC_BUILD_QUALITY_MEDIUM)
    rebuild_high,   // one tree with spatial splits, rebuilt; for scenes that do not move
};
inline constexpr std::array<BaselineUpdate, 5> kBaselineUpdates{BaselineUpdate::refit_instances,
    BaselineUpdate::refit, BaselineUpdate::rebuild_low, BaselineUpdate::rebuild_medium,
    BaselineUpdate::rebuild_high};

/// "refit-instances", ...
std::string_view baseline_update_name(BaselineUpdate update);

/// Times, in milliseconds, and counts of a frame. The stages primary, shadow and shade run tile by
/// tile on all threads: their times are sums over all threads, divided by the number of threads.
struct BaselineStats {
    double pose_ms = 0;
    double update_ms = 0;  // of the tree
    double primary_ms = 0; // rays from the eye, and runs of equal items
    double shadow_ms = 0;  // rays between hits and lights
    double shade_ms = 0;   // the cpu engine's shading, and storing
    double total_ms = 0;
    std::uint64_t updated_triangles = 0; // of the tree
    std::uint64_t hits = 0;
    std::uint64_t shadow_rays = 0;
};

} // namespace firsthit
