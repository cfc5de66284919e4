// cells.h - sorts samples and triangles into the cells of a grid over the samples' bounds.
#pragma once

#include "base/tasks.h"
#include "irregular/mesh/bin_triangles.h"
#include "irregular/mesh/pencil_mesh.h"
#include "irregular/mesh/samples.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// A grid over a rectangle of the face: column = (x - x0) * scale_x, row = (y - y0) * scale_y,
/// clamped to the grid. These functions are monotonic and the same for samples and for triangles'
/// boxes, so a triangle's cells include the cell of every sample in its box, whatever the
/// roundings.
struct CellGrid {
    float x0 = 0, y0 = 0;           // the corner of the rectangle
    float scale_x = 0, scale_y = 0; // cells per unit of the face
    int columns = 1, rows = 1;

    int cells() const { return columns * rows; }
};

/// The cells that a triangle's box overlaps, both ends included. column0 > column1: none.
struct CellRect {
    std::uint8_t column0, row0, column1, row1;
};

/// cell[k] = the cell of sample from[k]. Writes whole registers; up to 15 entries past the last one
/// are garbage.
void find_sample_cells(
    const CellGrid& grid, std::span<const IrregularSample> from, std::uint16_t* cell);

/// rect[k] = the cells of triangle from[k]; none if it cannot be hit (may_hit) by a ray to a sample
/// inside the bounds. Writes whole registers; up to 15 entries past the last one are garbage.
void find_triangle_cells(const CellGrid& grid, const SampleBounds& bounds,
    std::span<const ProjectedTriangle> from, CellRect* rect);

/// The bounds of samples.
SampleBounds bounds_of(std::span<const IrregularSample> samples);

/// The largest number of cells to ask cell_grid for, and of columns or rows of a grid.
inline constexpr std::size_t kMostCells = 1 << 14;
inline constexpr int kMostColumns = 255;

/// A grid of about `cells` cells, about square ones, over the bounds.
CellGrid cell_grid(const SampleBounds& bounds, std::size_t cells);

/// Samples and triangles sorted by cell. The memory is kept from frame to frame.
struct IrregularCells {
    SampleBounds bounds; // of all samples
    CellGrid grid;
    Buffer<IrregularSample, Pages::small> samples; // by cell
    Buffer<std::uint32_t> sample_start;            // (cells + 1)
    TriangleBins bins;                             // by cell
    Buffer<std::uint32_t> cursor;                  // (shares, cells), while sorting
    Buffer<std::uint16_t> cell_of;                 // (samples), while sorting
    Buffer<CellRect> rect_of;                      // (triangles), while sorting

    std::span<const IrregularSample> samples_of(std::size_t cell) const
    {
        return samples.span().subspan(
            sample_start[cell], sample_start[cell + 1] - sample_start[cell]);
    }
};

/// Fills in cells.samples and cells.sample_start for cells.grid.
/// ranges  of indices into `from`
void sort_samples(std::span<const IrregularSample> from, std::span<const SampleRange> ranges,
    IrregularCells& cells, Tasks& tasks);

/// Fills in cells.bins for cells.grid and cells.bounds: each triangle that may be hit (may_hit) is
/// copied to all cells that its box overlaps; for boxes over many cells, to those that do not lie
/// outside of an edge. Returns false, and sorts nothing, if that took too many copies
/// (bin_triangles).
bool sort_triangles(
    const PencilMesh& mesh, const TriangleRanges& from, IrregularCells& cells, Tasks& tasks);

} // namespace firsthit
