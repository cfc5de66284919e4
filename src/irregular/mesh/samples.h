// samples.h - the samples of the irregular z-buffer: points projected to a face of a pencil.
#pragma once

#include "base/buffer.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

namespace firsthit {

/// One projected point; see CubeFace for x, y and w. w is NaN where 1 / c is not finite: such
/// samples are always decided by the exact test, with the point that PencilPoints has for the id.
struct IrregularSample {
    float x, y, w;
    std::uint32_t id; // the caller's number of the point
};
static_assert(sizeof(IrregularSample) == 16);

/// Consecutive elements of an array.
struct SampleRange {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// The bounds of some samples; by default of none. A w of NaN counts as infinitely far (-infinity).
struct SampleBounds {
    float x0 = std::numeric_limits<float>::infinity();
    float y0 = std::numeric_limits<float>::infinity();
    float x1 = -std::numeric_limits<float>::infinity();
    float y1 = -std::numeric_limits<float>::infinity();
    float farthest_w = std::numeric_limits<float>::infinity();
    float nearest_w = -std::numeric_limits<float>::infinity();

    void add(const SampleBounds& other)
    {
        x0 = std::min(x0, other.x0);
        y0 = std::min(y0, other.y0);
        x1 = std::max(x1, other.x1);
        y1 = std::max(y1, other.y1);
        farthest_w = std::min(farthest_w, other.farthest_w);
        nearest_w = std::max(nearest_w, other.nearest_w);
    }
};

/// Samples of one face that came together, for instance from one tile of the picture.
struct SamplePatch {
    SampleRange range;
    SampleBounds bounds;
};

/// The samples of a face as they are given.
struct PatchedSamples {
    std::span<const IrregularSample> samples; // no two have the same id
    std::span<const SamplePatch> patches;     // ranges of `samples`
    const SampleBounds& bounds;               // of the samples of all patches
};

} // namespace firsthit
