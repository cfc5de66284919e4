// compare.h - holds the item buffer against other ray casters, each disagreement settled exactly.
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

} // namespace firsthit
