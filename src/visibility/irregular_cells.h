// irregular_cells.h - samples and triangles sorted into the cells of a grid over the samples.
#pragma once

#include "base/tasks.h"
#include "visibility/irregular_samples.h"
#include "visibility/light_mesh.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace firsthit {

/// A grid over a rectangle. The functions from x to column and from y to row never fall as their
/// argument grows, and are the same for samples and triangles: so a triangle meets all cells whose
/// samples it may cover, whatever is rounded.
struct CellGrid {
    float x0 = 0, y0 = 0;           // of the rectangle
    float scale_x = 0, scale_y = 0; // cells a unit
    int columns = 1, rows = 1;

    int column(float x) const { return place((x - x0) * scale_x, columns); }
    int row(float y) const { return place((y - y0) * scale_y, rows); }
    int cells() const { return columns * rows; }

  private:
    static int place(float cell, int count)
    {
        return cell > 0 ? int(std::min(cell, float(count - 1))) : 0; // 0 where it is no number
    }
};

/// The cells of samples, 16 at a time: cell[k] of from[k]. Up to 15 more are written.
void place_samples(
    const CellGrid& grid, std::span<const IrregularSample> from, std::uint16_t* cell);

/// Bounds of samples.
SampleBounds bounds_of(std::span<const IrregularSample> samples);

/// At most this many cells.
inline constexpr std::size_t kMostCells = 1 << 14;

/// About `cells` cells over the bounds, about square.
CellGrid cell_grid(const SampleBounds& bounds, std::size_t cells);

/// Kept from frame to frame.
struct IrregularCells {
    SampleBounds bounds; // of all samples
    CellGrid grid;
    Buffer<IrregularSample> samples;      // by cell
    Buffer<std::uint32_t> sample_start;   // (cells + 1)
    Buffer<SeenTriangle> triangles;       // by cell, then in their order
    Buffer<std::uint32_t> triangle_start; // (cells + 1)
    Buffer<std::uint32_t> cursor;         // (ranges, cells), while sorting
    Buffer<std::uint16_t> cell_of;        // (samples) while sorting
};

/// Sorts the samples of all ranges.
/// from  all that the ranges lie in
void sort_samples(std::span<const IrregularSample> from, std::span<const SampleRange> ranges,
    IrregularCells& cells, Tasks& tasks);

/// Copies each triangle that may shadow a sample to all cells that its box meets.
/// ranges  into `from`
/// returns  false where that would be more than a few a triangle: nothing is sorted then
bool sort_triangles(std::span<const SeenTriangle> from, std::span<const SampleRange> ranges,
    IrregularCells& cells, Tasks& tasks);

} // namespace firsthit
