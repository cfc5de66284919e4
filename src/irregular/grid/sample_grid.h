// sample_grid.h - a grid of samples in which a triangle finds the few samples that it may touch, so
// that triangles need not be sorted.
//
// The samples' bounds are cut into strips along x, about three sample distances high, and each
// strip into narrow cells, about as many as it has samples:
//
//      ____ _ _ _ _ _ _ _ _ ____          The samples of a strip are sorted by cell, so those
//     |_|_|_|_|_|_|_|_|_|_|_|_|  strip     between two columns are consecutive: a run. A
//     |___|___|___|___|___|___|           triangle about as large as the sample distance meets
//                                          one or two runs of a few samples.
//
// All tests are made with quantized coordinates (quantized_points.h), so that a sample is one word.
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"
#include "irregular/grid/quantized_points.h"
#include "irregular/cells/cell_kernel.h"
#include "irregular/mesh/bin_triangles.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// Strips begin at multiples of 2^kStripShift quantized rows.
inline constexpr int kStripShift = 4;
inline constexpr std::size_t kStripRows = 65536 >> kStripShift;

/// For each strip and each 2^kDepthShift quantized columns the farthest depth is known.
inline constexpr int kDepthShift = 8;
inline constexpr std::size_t kDepthColumns = 65536 >> kDepthShift;

/// A horizontal strip of cells. A sample is in the cell first + (quantized x >> shift).
struct GridStrip {
    std::uint32_t first = 0;
    std::uint32_t shift = 0;
    std::uint32_t sample = 0; // index of the strip's first sample
    std::uint32_t count = 0;  // number of samples
};

/// A sample between the two passes of the sort.
struct SortedSample {
    std::uint64_t quantized; // word of QuantizedPoint
    std::uint32_t item, sample_index;
};

/// The sorted samples of one face. The memory is kept from frame to frame.
struct SampleGrid {
    /// Entries that may be read after the last sample. They are in no box.
    static constexpr std::size_t kSpare = 32;

    SampleBounds bounds;
    GridAxes axes;
    std::span<const IrregularSample> samples; // the samples as they were given
    Buffer<std::uint16_t> strip_of;           // (kStripRows) the strip of y >> kStripShift
    Buffer<GridStrip> strips;
    /// (cells, and one more for each strip) the first sample of each cell, relative to the strip's
    /// first one; the last entry of a strip is its number of samples.
    Buffer<std::uint16_t> start;
    // (samples and kSpare) in the order of the cells:
    Buffer<std::uint64_t> quantized; // words of QuantizedPoint
    Buffer<std::uint16_t>
        farthest;               // (strips, kDepthColumns) the least w in this column and the next
    Buffer<std::uint32_t> item; // the triangle that each sample lies on, or kNoItem
    Buffer<std::uint32_t> sample_index; // index of each sample in `samples`; no spare ones

    /// The bound of the errors of quantized edge functions. An edge function of two corners and a
    /// sample, all in a box of width + height = S, differs from the exact one by at most
    /// (2.5 S << error_shift) + error_rest. Where roundings before quantizing are too large for
    /// that, error_rest is 2^30, which makes the test never certain.
    int error_shift = 0;
    std::uint32_t error_rest = 0;

    /// An estimate of how many samples a triangle of the size of the sample distance meets: a few,
    /// or many where samples crowd closer together than cells are wide.
    double crowding = 0;

    // Used only while sorting.
    Buffer<std::uint64_t> unsorted;   // words of QuantizedPoint, in the order of `samples`
    Buffer<std::uint32_t> row_counts; // (shares, kStripRows)
    Buffer<std::uint32_t> cursor;     // (shares, strips)
    Buffer<SortedSample> by_strip;
    Buffer<double> squares; // (strips) the sum of the squares of the cells' sample counts
};

/// How samples are laid out in the grid.
struct GridLayout {
    bool directional = false; // the pencil is parallel: samples' coordinates have no rounding error
    bool transposed = false;  // strips lie along y
};

/// Sorts samples into the grid. The span `patched.samples` must outlive the grid's use.
///
/// returns  false, with infinite crowding and nothing sorted, if a strip had more than 65535
///          samples
bool sort_into_grid(const PatchedSamples& patched, const GridLayout& view,
    const PencilPoints& points, SampleGrid& grid, Tasks& tasks);

} // namespace firsthit
