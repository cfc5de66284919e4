// sample_grid.h - samples of the irregular z-buffer, sorted so that a triangle finds the few that it
// may touch without being sorted itself.
//
// The samples' rectangle is cut into 64 x 64 coarse cells, and each of these, by how many samples it
// holds, into 1 x 1 to 128 x 128 cells. A cell knows its farthest sample, and which of its 8 x 8 parts
// hold any. Its samples lie in blocks of sixteen.
#pragma once

#include "base/tasks.h"
#include "visibility/grid_places.h"
#include "visibility/irregular_leaf.h"
#include "visibility/irregular_patches.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace firsthit {

/// 16 bytes.
struct GridCell {
    std::uint64_t occupied = 0;   // a bit for each part with a sample, 8 a row
    std::uint32_t first = 0;      // block; they end where the next cell's begin
    std::uint32_t farthest_w = 0; // place; kLastPlace without samples, 0 where a depth is no number
};

/// What all cells of a coarse cell share.
struct CoarseCell {
    std::uint32_t first = 0;
    std::uint16_t level = 0;      // 2^level rows and columns of cells
    std::uint16_t farthest_w = 0; // of all its samples, as a cell's
};

inline constexpr std::uint32_t kNoSample = 0xFFFFFFFFu;

/// Samples of one cell; the last block of a cell is filled up with kNoSample, mostly outside of all
/// boxes. A depth that is no number is -inf here, infinitely far.
struct alignas(64) GridBlock {
    static constexpr std::uint32_t kSamples = 16;
    float x[kSamples], y[kSamples], w[kSamples];
    std::uint32_t item[kSamples];
};

/// Kept from frame to frame.
struct SampleGrid {
    SampleBounds bounds;
    GridAxes axes;
    Buffer<CoarseCell> coarse; // (64 * 64)
    Buffer<GridCell> cells;    // after the last one a row of empty ones, and more
    Buffer<GridBlock> blocks;
    Buffer<std::uint32_t> id; // (blocks, 16)
    double crowding = 0;      // how many samples share the cell of a sample, on average

    // While sorting.
    Buffer<std::uint32_t> cell_of; // as the samples that were given; first their places
    Buffer<std::uint32_t> cursor, coarse_counts;
};

/// Sorts the samples of the patches.
/// bounds  of all of them
void sort_into_grid(std::span<const IrregularSample> samples, std::span<const SamplePatch> patches,
    const SampleBounds& bounds, const LightPoints& points, SampleGrid& grid, Tasks& tasks);

} // namespace firsthit
