// samples.h - points seen from a light: the samples of the irregular z-buffer.
#pragma once

#include "base/buffer.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace firsthit {

/// See CubeFace for x, y and w. A w that is no number stands for a depth whose inverse is not
/// finite: such samples are always decided exactly.
struct IrregularSample {
    float x, y, w;
    std::uint32_t id; // the caller's number of the point
};
static_assert(sizeof(IrregularSample) == 16);

/// Consecutive samples.
struct SampleRange {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// What holds all of some samples. Depths that are no number count as infinitely far.
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

} // namespace firsthit
