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
    if (sample_count == 0) triangle_ranges = {};
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
    const auto samples = cells.samples_of(cell);
    const auto triangles = cells.seen.of(cell);
    if (samples.empty() || triangles.empty()) return;
    if (level == kCellLevels || samples.size() <= kManySamples ||
        triangles.size() <= kManyTriangles) {
        test_leaf(mesh, samples, triangles, points, worker.leaf, shadowed);
        return;
    }
    IrregularCells& inner = worker.level[std::size_t(level)];
    const SampleRange all_samples{0, samples.size()}, all_triangles{0, triangles.size()};
    sort(samples, {&all_samples, 1}, samples.size(), triangles, {&all_triangles, 1},
        bounds_of(samples), inner, serial);
    if (inner.grid.cells() == 1) { // all in one place
        test_leaf(mesh, samples, triangles, points, worker.leaf, shadowed);
        return;
    }
    for (std::size_t k = 0; k < std::size_t(inner.grid.cells()); ++k)
        test_cell(mesh, inner, k, level + 1, points, worker, serial, shadowed);
}

} // namespace

void sort_face(const LightMesh& mesh, std::span<const IrregularSample> samples,
    std::span<const SamplePatch> patches, const SampleBounds& bounds, IrregularMemory& memory,
    Tasks& tasks)
{
    memory.samples = samples;
    memory.triangle_ranges.resize(mesh.range_count.size());
    std::size_t triangle_count = 0, count = 0;
    for (std::size_t k = 0; k < mesh.range_count.size(); ++k) {
        memory.triangle_ranges[k] = {k * kLightRange, mesh.range_count[k]};
        triangle_count += mesh.range_count[k];
    }
    for (const SamplePatch& patch : patches) count += patch.range.count;

    memory.loose.resize(patches.size());
    memory.patches.patches.resize(patches.size());
    std::size_t compact = 0, loose = 0, loose_count = 0;
    SampleBounds loose_bounds;
    for (const SamplePatch& patch : patches) {
        if (patch.range.count == 0) continue;
        if (is_compact(patch, bounds, triangle_count)) {
            memory.patches.patches[compact++] = patch;
        } else {
            memory.loose[loose++] = patch.range;
            loose_count += patch.range.count;
            loose_bounds.add(patch.bounds);
        }
    }
    const auto triangles = mesh.in_view.span();
    const auto ranges = memory.triangle_ranges.span();
    memory.patches.patches.resize(compact);
    if (!bin_patches(triangles, ranges, bounds, memory.patches, tasks)) {
        // Too many large triangles: everything is sorted, into as few cells as need be.
        memory.patches.patches.resize(0);
        loose = 0;
        loose_count = count;
        loose_bounds = bounds;
        for (const SamplePatch& patch : patches) memory.loose[loose++] = patch.range;
    }
    memory.loose.resize(loose);
    sort(samples, memory.loose.span(), loose_count, triangles, ranges, loose_bounds, memory.cells,
        tasks);
}

void test_face(const LightMesh& mesh, const LightPoints& points, IrregularMemory& memory,
    Tasks& tasks, std::span<std::uint8_t> shadowed)
{
    while (int(memory.workers.size()) < tasks.threads())
        memory.workers.push_back(std::make_unique<CellWorker>());
    const PatchMemory& patches = memory.patches;
    tasks.for_each(patches.patches.size(), [&](std::size_t k, std::size_t worker) {
        const SampleRange& range = patches.patches[k].range;
        const auto triangles = patches.seen.of(k);
        if (!triangles.empty())
            test_leaf(mesh, memory.samples.subspan(range.first, range.count), triangles, points,
                memory.workers[worker]->leaf, shadowed);
    });
    const IrregularCells& cells = memory.cells;
    tasks.for_each(std::size_t(cells.grid.cells()), [&](std::size_t cell, std::size_t worker) {
        test_cell(mesh, cells, cell, 0, points, *memory.workers[worker], memory.serial, shadowed);
    });
}

} // namespace firsthit
