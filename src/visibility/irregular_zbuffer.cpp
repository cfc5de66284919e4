// irregular_zbuffer.cpp - which points can a light not see?
#include "visibility/irregular_zbuffer.h"

namespace firsthit {
namespace {

constexpr std::size_t kCellSamples = 768;   // wanted in a cell
constexpr std::size_t kManySamples = 4096;  // more than these are divided again
constexpr std::size_t kManyTriangles = 128; // where there are more than these triangles

/// Sorts samples and triangles into about as many cells as give each its share of samples, fewer
/// where large triangles would be copied too often.
void sort(std::span<const IrregularSample> samples, std::span<const SampleRange> sample_ranges,
    std::size_t sample_count, std::span<const SeenTriangle> triangles,
    std::span<const SampleRange> triangle_ranges, const SampleBounds& bounds, IrregularCells& cells,
    Tasks& tasks)
{
    cells.bounds = bounds;
    std::size_t wanted = std::clamp<std::size_t>(sample_count / kCellSamples, 1, kMostCells);
    for (;; wanted = (wanted + 3) / 4) {
        cells.grid = cell_grid(bounds, wanted);
        if (sort_triangles(triangles, triangle_ranges, cells, tasks)) break;
    }
    sort_samples(samples, sample_ranges, cells, tasks);
}

/// A cell by itself, or divided into smaller ones.
void test_cell(const LightMesh& mesh, const IrregularCells& cells, std::size_t cell, int level,
    const LightPoints& points, CellWorker& worker, Tasks& serial, std::span<std::uint8_t> shadowed)
{
    const SampleRange range{
        cells.sample_start[cell], cells.sample_start[cell + 1] - cells.sample_start[cell]};
    const std::size_t first = cells.triangle_start[cell],
                      count = cells.triangle_start[cell + 1] - first;
    if (range.count == 0 || count == 0) return;
    const auto triangles = cells.triangles.span().subspan(first, count);
    const auto own = cells.samples.span().subspan(range.first, range.count);
    if (level == kCellLevels || range.count <= kManySamples || count <= kManyTriangles) {
        test_leaf(mesh, own, triangles, points, worker.leaf, shadowed);
        return;
    }
    IrregularCells& inner = worker.level[std::size_t(level)];
    const SampleRange all{0, count};
    sort(cells.samples.span(), {&range, 1}, range.count, triangles, {&all, 1}, bounds_of(own),
        inner, serial);
    if (inner.grid.cells() == 1) { // all in one place
        test_leaf(mesh, own, triangles, points, worker.leaf, shadowed);
        return;
    }
    for (std::size_t k = 0; k < std::size_t(inner.grid.cells()); ++k)
        test_cell(mesh, inner, k, level + 1, points, worker, serial, shadowed);
}

} // namespace

void sort_face(const LightMesh& mesh, std::span<const IrregularSample> samples,
    std::span<const SampleRange> ranges, const SampleBounds& bounds, IrregularMemory& memory,
    Tasks& tasks)
{
    std::size_t count = 0;
    for (const SampleRange& range : ranges) count += range.count;
    memory.triangle_ranges.resize(mesh.range_count.size());
    for (std::size_t k = 0; k < mesh.range_count.size(); ++k)
        memory.triangle_ranges[k] = {k * kLightRange, mesh.range_count[k]};
    sort(samples, ranges, count, mesh.in_view.span(), memory.triangle_ranges.span(), bounds,
        memory.cells, tasks);
}

void test_face(const LightMesh& mesh, const LightPoints& points, IrregularMemory& memory,
    Tasks& tasks, std::span<std::uint8_t> shadowed)
{
    while (int(memory.workers.size()) < tasks.threads())
        memory.workers.push_back(std::make_unique<CellWorker>());
    const IrregularCells& cells = memory.cells;
    tasks.for_each(std::size_t(cells.grid.cells()), [&](std::size_t cell, std::size_t worker) {
        test_cell(mesh, cells, cell, 0, points, *memory.workers[worker], memory.serial, shadowed);
    });
}

} // namespace firsthit
