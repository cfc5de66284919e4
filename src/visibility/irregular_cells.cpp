// irregular_cells.cpp - samples and triangles sorted into cells: counting sorts in three passes.
#include "visibility/irregular_cells.h"

#include <cmath>

namespace firsthit {
namespace {

/// Copies beyond four a triangle that are accepted at once: 400 MB.
constexpr std::uint64_t kManyCopies = std::uint64_t(1) << 24;

/// From counts in cursor (ranges, cells) to where each range writes its part of each cell. Returns
/// the sum.
std::uint64_t start_cells(std::size_t ranges, std::size_t cells, Buffer<std::uint32_t>& cursor,
    Buffer<std::uint32_t>& start)
{
    start.resize(cells + 1);
    std::uint64_t next = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        start[cell] = std::uint32_t(next);
        for (std::size_t range = 0; range < ranges; ++range) {
            std::uint32_t& at = cursor[range * cells + cell];
            const std::uint32_t count = at;
            at = std::uint32_t(next);
            next += count;
        }
    }
    start[cells] = std::uint32_t(next);
    return next;
}

template <class F>
void for_cells(const SeenTriangle& box, const IrregularCells& cells, const F& f)
{
    if (!may_shadow(box, cells.bounds)) return;
    const CellGrid& grid = cells.grid;
    const int first_column = grid.column(box.x0), last_column = grid.column(box.x1);
    const int first_row = grid.row(box.y0), last_row = grid.row(box.y1);
    for (int row = first_row; row <= last_row; ++row)
        for (int column = first_column; column <= last_column; ++column)
            f(row * grid.columns + column);
}

/// Consecutive ranges that one task sorts, so that there are not many more counts than samples.
struct Shares {
    std::size_t count, size;

    Shares(std::size_t ranges, std::size_t threads)
        : count(std::min(ranges, threads == 1 ? 1 : 4 * threads)),
          size(count ? (ranges + count - 1) / count : 0)
    {
    }

    template <class T>
    std::span<const T> of(std::span<const T> ranges, std::size_t share) const
    {
        const std::size_t first = std::min(share * size, ranges.size());
        return ranges.subspan(first, std::min(size, ranges.size() - first));
    }
};

} // namespace

CellGrid cell_grid(const SampleBounds& bounds, std::size_t cells)
{
    const double width = double(bounds.x1) - double(bounds.x0),
                 height = double(bounds.y1) - double(bounds.y0);
    CellGrid grid;
    grid.x0 = bounds.x0;
    grid.y0 = bounds.y0;
    // A side of nearly no length has one column.
    const double square = std::sqrt(std::max(width * height, 0.0) / double(cells));
    const double longest = std::max(width, height) / double(cells);
    const double side = std::max(square, longest);
    const auto count = [&](double length) {
        return side > 0 ? std::clamp(int(std::ceil(length / side)), 1, int(cells)) : 1;
    };
    grid.columns = count(width);
    grid.rows = count(height);
    const auto scale = [](int n, double length) {
        const float s = length > 0 ? float(n / length) : 0.0f;
        return std::isfinite(s) ? s : 0.0f;
    };
    grid.scale_x = scale(grid.columns, width);
    grid.scale_y = scale(grid.rows, height);
    return grid;
}

void sort_samples(std::span<const IrregularSample> from, std::span<const SampleRange> ranges,
    IrregularCells& cells, Tasks& tasks)
{
    const CellGrid grid = cells.grid;
    const std::size_t count = std::size_t(grid.cells());
    const Shares shares(ranges.size(), std::size_t(tasks.threads()));
    cells.cursor.resize(shares.count * count);
    cells.cell_of.resize(from.size() + 16);
    tasks.for_each(shares.count, [&](std::size_t share, std::size_t) {
        std::uint32_t* counts = &cells.cursor[share * count];
        std::fill_n(counts, count, 0u);
        for (const SampleRange& range : shares.of(ranges, share)) {
            std::uint16_t* cell = &cells.cell_of[range.first];
            place_samples(grid, from.subspan(range.first, range.count), cell);
            for (std::size_t k = 0; k < range.count; ++k) ++counts[cell[k]];
        }
    });
    const std::uint64_t total = start_cells(shares.count, count, cells.cursor, cells.sample_start);
    cells.samples.resize(total, total / 4 + 4096);
    tasks.for_each(shares.count, [&](std::size_t share, std::size_t) {
        std::uint32_t* cursor = &cells.cursor[share * count];
        for (const SampleRange& range : shares.of(ranges, share))
            for (std::size_t k = range.first; k < range.first + range.count; ++k)
                cells.samples[cursor[cells.cell_of[k]]++] = from[k];
    });
}

bool sort_triangles(std::span<const SeenTriangle> from, std::span<const SampleRange> ranges,
    IrregularCells& cells, Tasks& tasks)
{
    const std::size_t count = std::size_t(cells.grid.cells());
    const Shares shares(ranges.size(), std::size_t(tasks.threads()));
    cells.cursor.resize(shares.count * count);
    tasks.for_each(shares.count, [&](std::size_t share, std::size_t) {
        std::uint32_t* counts = &cells.cursor[share * count];
        std::fill_n(counts, count, 0u);
        for (const SampleRange& range : shares.of(ranges, share))
            for (const SeenTriangle& box : from.subspan(range.first, range.count))
                for_cells(box, cells, [&](int cell) { ++counts[cell]; });
    });
    const std::uint64_t total =
        start_cells(shares.count, count, cells.cursor, cells.triangle_start);
    if (total > kManyCopies + 4 * from.size() && count > 1) return false;
    cells.triangles.resize(total, total / 4 + 4096);
    tasks.for_each(shares.count, [&](std::size_t share, std::size_t) {
        std::uint32_t* cursor = &cells.cursor[share * count];
        for (const SampleRange& range : shares.of(ranges, share))
            for (const SeenTriangle& box : from.subspan(range.first, range.count))
                for_cells(box, cells, [&](int cell) { cells.triangles[cursor[cell]++] = box; });
    });
    return true;
}

} // namespace firsthit
