// grid_runs.h - looks up the samples of a sample grid (sample_grid.h) that a box may contain.
#pragma once

#include "irregular/grid/sample_grid.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace firsthit {

/// The strips that a box overlaps, both ends included.
struct StripRange {
    std::uint16_t first, last;
};

/// low, high  corners of the box: words of QuantizedPoint
inline StripRange strips_of(const SampleGrid& grid, std::uint64_t low, std::uint64_t high)
{
    constexpr int kRow = 48 + kStripShift;
    return {grid.strip_of[low >> kRow], grid.strip_of[high >> kRow]};
}

/// Consecutive samples [first, last) of the grid.
struct GridRun {
    std::uint32_t first, last;
};

/// The samples of strip `number` in the columns that the box overlaps.
inline GridRun run_of(
    const SampleGrid& grid, std::uint32_t number, std::uint64_t low, std::uint64_t high)
{
    const GridStrip& strip = grid.strips[number];
    const std::uint16_t* start = &grid.start[strip.first];
    return {strip.sample + start[(low >> 32 & 0xFFFF) >> strip.shift],
        strip.sample + start[((high >> 32 & 0xFFFF) >> strip.shift) + 1]};
}

/// Whether everything in the box is certainly behind all samples around it. Always false for a box
/// over more than two strips or depth columns.
inline bool is_behind(
    const SampleGrid& grid, StripRange strips, std::uint64_t low, std::uint64_t high)
{
    constexpr int kColumn = 32 + kDepthShift;
    const std::size_t column = low >> kColumn & (kDepthColumns - 1),
                      last_column = high >> kColumn & (kDepthColumns - 1);
    const std::uint16_t farthest = std::min(grid.farthest[strips.first * kDepthColumns + column],
        grid.farthest[strips.last * kDepthColumns + column]);
    const bool small = (last_column - column <= 1) & (strips.last - strips.first <= 1);
    return small & (std::uint16_t(high) < farthest);
}

} // namespace firsthit
