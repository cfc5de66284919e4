// baseline_options.h - how the ray tracer with a tree is run, and what it reports.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace firsthit {

/// How Embree's tree follows a scene. Where nothing has moved since the frame before, the tree stays as
/// it is.
enum class BaselineUpdate {
    refit_parts,    // a tree for each part, refitted where it has moved, and one over all parts
    refit,          // one tree of medium quality, its boxes refitted
    rebuild_low,    // one tree, built anew: quickly, along a curve (RTC_BUILD_QUALITY_LOW)
    rebuild_medium, // one tree, built anew (RTC_BUILD_QUALITY_MEDIUM)
    rebuild_high,   // one tree with spatial splits, for scenes that stand still
};
inline constexpr std::array<BaselineUpdate, 5> kBaselineUpdates{BaselineUpdate::refit_parts,
    BaselineUpdate::refit, BaselineUpdate::rebuild_low, BaselineUpdate::rebuild_medium,
    BaselineUpdate::rebuild_high};

/// "refit-parts", ...
std::string_view baseline_update_name(BaselineUpdate update);

/// Where a frame's time went, milliseconds. Primary, shadow and shade run tile by tile on all threads:
/// their sum over the threads, divided by the number of threads.
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
