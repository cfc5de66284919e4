// irregular_cells.cpp - samples and triangles sorted into cells: counting sorts in three passes.
#include "visibility/irregular_cells.h"

#include <cmath>

namespace firsthit {

std::uint64_t start_bins(std::size_t shares, std::size_t bins, Buffer<std::uint32_t>& cursor,
    Buffer<std::uint32_t>& start)
{
    start.resize(bins + 1);
    std::uint64_t next = 0;
    for (std::size_t bin = 0; bin < bins; ++bin) {
        start[bin] = std::uint32_t(next);
        for (std::size_t share = 0; share < shares; ++share) {
            std::uint32_t& at = cursor[share * bins + bin];
            const std::uint32_t count = at;
            at = std::uint32_t(next);
            next += count;
        }
    }
    start[bins] = std::uint32_t(next);
    return next;
}

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
        return side > 0 ? std::clamp(int(std::ceil(length / side)), 1, kMostColumns) : 1;
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
    const std::uint64_t total = start_bins(shares.count, count, cells.cursor, cells.sample_start);
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
    cells.rect_of.resize(from.size() + 16);
    tasks.for_each(ranges.size(), [&](std::size_t k, std::size_t) {
        const SampleRange& range = ranges[k];
        place_triangles(cells.grid, cells.bounds, from.subspan(range.first, range.count),
            &cells.rect_of[range.first]);
    });
    const auto for_cells = [&](std::size_t k, const auto& f) {
        const CellRect rect = cells.rect_of[k];
        for (int row = rect.row0; row <= rect.row1; ++row)
            for (int column = rect.column0; column <= rect.column1; ++column)
                f(std::size_t(row * cells.grid.columns + column));
    };
    return bin_seen(from, ranges, std::size_t(cells.grid.cells()), for_cells, cells.seen, tasks);
}

} // namespace firsthit
