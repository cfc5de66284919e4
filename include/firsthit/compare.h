// compare.h - holds items and shadows against other ray casters, each disagreement settled exactly.
#pragma once

#include <firsthit/scene.h>
#include <firsthit/view.h>

#include <cstdint>
#include <functional>

namespace firsthit {

enum class Oracle {
    brute,  // every triangle for every pixel, with the exact predicate
    embree, // Embree 3, robust flag
};

/// agree + ties + ours_wrong + theirs_wrong = pixels (both_wrong is counted in ours_wrong).
struct Comparison {
    std::uint64_t pixels = 0;
    std::uint64_t agree = 0;        // the same item
    std::uint64_t ties = 0;         // different items at exactly the same depth
    std::uint64_t ours_wrong = 0;   // exact arithmetic says: ours is not the nearest hit, lowest id
    std::uint64_t theirs_wrong = 0; // exact arithmetic says: ours is right, theirs is not
};

/// Compares the items of one frame with those of another caster.
/// progress  called on one thread now and then with the share of the casting that is done
/// throws    DeviceError where the build has no Embree; ArgumentError as Renderer::render
Comparison compare(const World& world, const View& view, Oracle oracle, int threads = 0,
    const std::function<void(double)>& progress = {});

/// Of all hits and all lights: does the light reach the hit? agree + ours_wrong + theirs_wrong =
/// pixels.
struct LitComparison {
    std::uint64_t pixels = 0; // hits times lights
    std::uint64_t agree = 0;
    std::uint64_t ours_wrong = 0;   // the plain loop over all triangles says otherwise
    std::uint64_t theirs_wrong = 0; // it says that ours is right
};

/// Compares the exact shadows of one frame (Aov::lit) with those of another caster for the same
/// points; which side of a surface a light is on, and cones, are compared as well.
/// progress  as compare
/// throws    as compare; SceneError: a light that is no sound one
LitComparison compare_lit(const World& world, const View& view, Oracle oracle, int threads = 0,
    const std::function<void(double)>& progress = {});

} // namespace firsthit
