// sample_grid.h - samples of the irregular z-buffer, sorted so that a triangle finds the few that it
// may touch without being sorted itself.
//
// The samples' rectangle is cut into strips along x, each as high as a few samples lie apart, and
// these into narrow cells, about as many as samples:
//
//      ____ _ _ _ _ _ _ _ _ ____          The samples of a strip lie in the order of its cells, so
//     |_|_|_|_|_|_|_|_|_|_|_|_|  strip     those between two columns are one run. A triangle as
//     |___|___|___|___|___|___|           small as samples meets one or two runs of a few.
//
// Everything is decided in places (quantized_points.h), so that a sample is one word.
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"
#include "irregular/grid/quantized_points.h"
#include "irregular/cells/cell_kernel.h"
#include "irregular/cells/patches.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// Rows of places that no strip divides.
inline constexpr int kStripShift = 4;
inline constexpr std::size_t kStripRows = 65536 >> kStripShift;

/// Columns of a strip that know how far their samples lie.
inline constexpr int kDepthShift = 8;
inline constexpr std::size_t kDepthColumns = 65536 >> kDepthShift;

/// A point's cell is first + (x >> shift).
struct GridStrip {
    std::uint32_t first = 0;
    std::uint32_t shift = 0;
    std::uint32_t sample = 0; // the first one
    std::uint32_t count = 0;  // of samples
};

/// A sample on its way to its strip.
struct SortedSample {
    std::uint64_t quantized; // as in SampleGrid
    std::uint32_t item, sample_index;
};

/// Kept from frame to frame.
struct SampleGrid {
    /// Samples that may be read or asked for after the last one; they lie nowhere.
    static constexpr std::size_t kSpare = 32;

    SampleBounds bounds;
    GridAxes axes;
    std::span<const IrregularSample> samples; // that were sorted
    Buffer<std::uint16_t> strip_of;           // (kStripRows) the strip of y >> kStripShift
    Buffer<GridStrip> strips;
    Buffer<std::uint16_t> start; // (cells) the first sample, from the strip's; at last their end
    Buffer<std::uint64_t> quantized; // (samples) QuantizedPoint
    Buffer<std::uint16_t>
        farthest;               // (strips, kDepthColumns) the least w in this column and the next
    Buffer<std::uint32_t> item; // (samples) the triangle that each lies on
    Buffer<std::uint32_t> sample_index; // (samples) of each in `samples`

    /// By how much places may be off: an edge of two corners and a sample, all in a box whose width
    /// and height are S, is at most (2.5 S << error_shift) + error_rest from what it is without
    /// roundings. error_rest is too large for all edges where places are too coarse to tell.
    int error_shift = 0;
    std::uint32_t error_rest = 0;

    /// How many samples lie where a triangle of their size meets its samples, on average: a few,
    /// unless they crowd together more than the grid can tell apart.
    double crowding = 0;

    // While sorting.
    Buffer<std::uint64_t> unsorted;   // places, as the samples that were given
    Buffer<std::uint32_t> row_counts; // (shares, kStripRows)
    Buffer<std::uint32_t> cursor;     // (shares, strips)
    Buffer<SortedSample> by_strip;
    Buffer<double> squares; // (strips) of the cells' samples
};

/// Who looks at the samples.
struct GridLayout {
    bool directional = false; // a face whose samples are not rounded
    bool transposed = false;  // strips are to lie along y
};

/// Sorts the samples of the patches; they have to stay. False where that cannot be: too many lie in
/// one row of places.
/// bounds  of all of them
bool sort_into_grid(std::span<const IrregularSample> samples, std::span<const SamplePatch> patches,
    const SampleBounds& bounds, const GridLayout& view, const PencilPoints& points,
    SampleGrid& grid, Tasks& tasks);

} // namespace firsthit
