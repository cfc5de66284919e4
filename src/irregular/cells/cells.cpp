// cells.cpp - sorts samples and triangles into the cells of a grid, by counting sorts in three
// passes.
#include "irregular/cells/cells.h"

#include <cmath>
#include <cstring>

namespace firsthit {

namespace {

/// Calls f(k, length) for runs of samples that are all in one cell: for sixteen samples together
/// where they are, which is the most frequent case, else for each sample.
template <class F>
void for_runs(const std::uint16_t* cell, std::size_t count, const F& f)
{
    constexpr std::size_t kRun = 16;
    std::size_t k = 0;
    for (; k + kRun <= count; k += kRun) {
        std::uint64_t four[4];
        std::memcpy(four, cell + k, sizeof four);
        const std::uint64_t same = cell[k] * 0x0001000100010001u;
        if (((four[0] ^ same) | (four[1] ^ same) | (four[2] ^ same) | (four[3] ^ same)) == 0)
            f(k, kRun);
        else
            for (std::size_t i = k; i < k + kRun; ++i) f(i, std::size_t(1));
    }
    for (; k < count; ++k) f(k, std::size_t(1));
}

} // namespace

CellGrid cell_grid(const SampleBounds& bounds, std::size_t cells)
{
    const double width = double(bounds.x1) - double(bounds.x0),
                 height = double(bounds.y1) - double(bounds.y0);
    CellGrid grid;
    grid.x0 = bounds.x0;
    grid.y0 = bounds.y0;
    // Cells are squares where they can be; a side shorter than a cell has one column or row.
    const double square = std::sqrt(std::max(width * height, 0.0) / double(cells));
    const double longest = std::max(width, height) / double(cells);
    const double side = std::max(square, longest);
    const auto count = [&](double length) {
        return length > 0 ? std::clamp(int(std::ceil(length / side)), 1, kMostColumns) : 1;
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
    cells.cursor.resize(shares.count * count, shares.count * count + 4096);
    cells.cell_of.resize(from.size() + 16);
    tasks.for_each(shares.count, [&](std::size_t share, std::size_t) {
        std::uint32_t* counts = &cells.cursor[share * count];
        std::fill_n(counts, count, 0u);
        for (const SampleRange& range : shares.of(ranges, share)) {
            std::uint16_t* cell = &cells.cell_of[range.first];
            find_sample_cells(grid, from.subspan(range.first, range.count), cell);
            for_runs(cell, range.count, [&](std::size_t k, std::size_t length) {
                counts[cell[k]] += std::uint32_t(length);
            });
        }
    });
    const std::uint64_t total = start_bins(shares.count, count, cells.cursor, cells.sample_start);
    cells.samples.resize(total, from.size() - std::min(from.size(), std::size_t(total)));
    tasks.for_each(shares.count, [&](std::size_t share, std::size_t) {
        std::uint32_t* cursor = &cells.cursor[share * count];
        for (const SampleRange& range : shares.of(ranges, share)) {
            const std::uint16_t* cell = &cells.cell_of[range.first];
            const IrregularSample* sample = &from[range.first];
            for_runs(cell, range.count, [&](std::size_t k, std::size_t length) {
                std::uint32_t& at = cursor[cell[k]];
                std::memcpy(&cells.samples[at], sample + k, length * sizeof(IrregularSample));
                at += std::uint32_t(length);
            });
        }
    });
}

namespace {

constexpr int kManyCells =
    9; // a box over fewer cells is copied to all of them, without an EdgeTest

/// Finds cells that lie outside of an edge of a projected triangle. Corners and samples are
/// rounded, so each edge is moved outwards by kTolerance times the largest coordinate.
class EdgeTest {
  public:
    EdgeTest(const PencilMesh& mesh, std::uint32_t triangle, const CellGrid& grid)
        : x0_(grid.x0),
          y0_(grid.y0),
          width_(1 / double(grid.scale_x)), // infinite if the scale is 0: then misses() is false
          height_(1 / double(grid.scale_y))
    {
        const glm::uvec3& index = mesh.index[triangle];
        const ProjectedPoint corner[3] = {
            mesh.projected[index.x], mesh.projected[index.y], mesh.projected[index.z]};
        const auto dx = [&](int a, int b) { return double(corner[b].x) - double(corner[a].x); };
        const auto dy = [&](int a, int b) { return double(corner[b].y) - double(corner[a].y); };
        const double area = dx(0, 1) * dy(0, 2) - dy(0, 1) * dx(0, 2);
        double largest =
            std::max(std::abs(x0_) + width_ * grid.columns, std::abs(y0_) + height_ * grid.rows);
        for (const ProjectedPoint& c : corner)
            largest = std::max({largest, double(std::abs(c.x)), double(std::abs(c.y))});
        const double size =
            std::abs(dx(0, 1)) + std::abs(dy(0, 1)) + std::abs(dx(0, 2)) + std::abs(dy(0, 2));
        // The edges stay 0, so that misses() is false, where roundings might have flipped the
        // triangle's orientation, and where a corner is NaN: then this comparison is false.
        if (!(largest < 1e30 && std::abs(area) > 4 * kTolerance * largest * size)) return;
        const double side = area < 0 ? -1 : 1;
        for (int k = 0; k < 3; ++k) {
            const int next = (k + 1) % 3;
            Edge& e = edge_[k];
            e.nx = -side * dy(k, next);
            e.ny = side * dx(k, next);
            e.c = -(e.nx * double(corner[k].x) + e.ny * double(corner[k].y)) +
                  kTolerance * largest * (std::abs(e.nx) + std::abs(e.ny));
        }
    }

    /// Whether the cell certainly lies outside of an edge.
    bool misses(std::size_t column, std::size_t row) const
    {
        const double x = x0_ + width_ * double(column), y = y0_ + height_ * double(row);
        for (const Edge& e : edge_)
            if (e.nx * (e.nx > 0 ? x + width_ : x) + e.ny * (e.ny > 0 ? y + height_ : y) + e.c < 0)
                return true;
        return false;
    }

  private:
    static constexpr double kTolerance = 0x1p-18;

    struct Edge {
        double nx = 0, ny = 0, c = 0; // inside: nx x + ny y + c >= 0
    };
    Edge edge_[3];
    double x0_, y0_, width_, height_;
};

} // namespace

bool sort_triangles(
    const PencilMesh& mesh, const TriangleRanges& from, IrregularCells& cells, Tasks& tasks)
{
    cells.rect_of.resize(from.array.size() + 16);
    tasks.for_each(from.ranges.size(), [&](std::size_t k, std::size_t) {
        const SampleRange& range = from.ranges[k];
        find_triangle_cells(cells.grid, cells.bounds, from.array.subspan(range.first, range.count),
            &cells.rect_of[range.first]);
    });
    const std::size_t columns = std::size_t(cells.grid.columns);
    const CellRect* rects = cells.rect_of.data();
    const auto for_cells = [&, rects, columns](std::size_t k, const auto& f) {
        const CellRect rect = rects[k];
        if (rect.column0 == rect.column1 && rect.row0 == rect.row1) { // the case of small triangles
            f(rect.row0 * columns + rect.column0);
            return;
        }
        if ((rect.column1 - rect.column0 + 1) * (rect.row1 - rect.row0 + 1) < kManyCells) {
            for (std::size_t row = rect.row0; row <= rect.row1; ++row)
                for (std::size_t column = rect.column0; column <= rect.column1; ++column)
                    f(row * columns + column);
            return;
        }
        if (rect.column0 > rect.column1) return;
        const EdgeTest edges(mesh, from.array[k].triangle, cells.grid);
        for (std::size_t row = rect.row0; row <= rect.row1; ++row)
            for (std::size_t column = rect.column0; column <= rect.column1; ++column)
                if (!edges.misses(column, row)) f(row * columns + column);
    };
    return bin_triangles(from, std::size_t(cells.grid.cells()), for_cells, cells.bins, tasks);
}

} // namespace firsthit
