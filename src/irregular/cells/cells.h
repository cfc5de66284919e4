// cells.h - samples and triangles sorted into the cells of a grid over the samples.
#pragma once

#include "base/tasks.h"
#include "irregular/mesh/bin_triangles.h"
#include "irregular/mesh/pencil_mesh.h"
#include "irregular/mesh/samples.h"

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

    int cells() const { return columns * rows; }
};

/// The cells that a triangle meets, ends included; first > last where it meets none.
struct CellRect {
    std::uint8_t column0, row0, column1, row1;
};

/// The cells of samples, 16 at a time: cell[k] of from[k]. Up to 15 more are written.
void find_sample_cells(
    const CellGrid& grid, std::span<const IrregularSample> from, std::uint16_t* cell);

/// The cells of triangles; none for one that may shadow no sample inside the bounds.
void find_triangle_cells(const CellGrid& grid, const SampleBounds& bounds,
    std::span<const ProjectedTriangle> from, CellRect* rect);

/// Bounds of samples.
SampleBounds bounds_of(std::span<const IrregularSample> samples);

/// At most this many cells.
inline constexpr std::size_t kMostCells = 1 << 14;
inline constexpr int kMostColumns = 255; // or rows

/// About `cells` cells over the bounds, about square.
CellGrid cell_grid(const SampleBounds& bounds, std::size_t cells);

/// Kept from frame to frame.
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

/// Sorts the samples of all ranges.
/// from  all that the ranges lie in
void sort_samples(std::span<const IrregularSample> from, std::span<const SampleRange> ranges,
    IrregularCells& cells, Tasks& tasks);

/// Copies each triangle that may shadow a sample to all cells that it may meet: those of its box, or
/// of a triangle over many cells only those that all its edges leave open. Returns what bin_triangles
/// does.
bool sort_triangles(const PencilMesh& mesh, std::span<const ProjectedTriangle> from,
    std::span<const SampleRange> ranges, IrregularCells& cells, Tasks& tasks);

} // namespace firsthit
