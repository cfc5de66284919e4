// zbuffer.cpp - finds which points are shadowed, by the irregular z-buffer.
#include "irregular/zbuffer.h"

namespace firsthit {
namespace {

constexpr std::size_t kCellSamples = 768; // samples of a cell, on average
// A cell with more samples and more triangles than these is divided again.
constexpr std::size_t kManySamples = 4096;
constexpr std::size_t kManyTriangles = 128;

/// Samples that are to be sorted into cells.
struct LooseSamples {
    std::span<const IrregularSample> array;
    std::span<const SampleRange> ranges; // of indices into `array`
    std::size_t count = 0;               // in the ranges
    SampleBounds bounds;
};

/// Sorts samples and triangles into cells of about kCellSamples samples; into fewer cells if large
/// triangles would be copied too often.
void sort_into_cells(const PencilMesh& mesh, const LooseSamples& samples, TriangleRanges triangles,
    IrregularCells& cells, Tasks& tasks)
{
    cells.bounds = samples.bounds;
    if (samples.count == 0) triangles.ranges = {};
    std::size_t wanted = std::clamp<std::size_t>(samples.count / kCellSamples, 1, kMostCells);
    for (;; wanted = (wanted + 3) / 4) {
        cells.grid = cell_grid(samples.bounds, wanted);
        if (sort_triangles(mesh, triangles, cells, tasks)) break;
    }
    sort_samples(samples.array, samples.ranges, cells, tasks);
}

void mark_shadowed(std::span<const IrregularSample> samples, std::span<std::uint8_t> shadowed)
{
    for (const IrregularSample& sample : samples) shadowed[sample.id] = 1;
}

bool should_divide(const IrregularCells& cells, std::size_t cell)
{
    return cells.samples_of(cell).size() > kManySamples &&
           cells.bins.of(cell).size() > kManyTriangles;
}

/// Tests the cells of a face on one worker.
struct CellTester {
    const PencilMesh& mesh;
    const FaceOccluders& occluders;
    const PencilPoints& points;
    std::span<std::uint8_t> shadowed; // by id
    CellWorker& worker;
    Tasks& serial;

    /// Tests the samples of a cell, or divides the cell and tests the smaller ones.
    void test_or_divide(const IrregularCells& cells, std::size_t cell, int level) const;
};

void CellTester::test_or_divide(const IrregularCells& cells, std::size_t cell, int level) const
{
    const auto samples = cells.samples_of(cell);
    const auto triangles = cells.bins.of(cell);
    if (samples.empty() || triangles.empty()) return;
    const SampleBounds bounds = bounds_of(samples);
    if (is_occluded(mesh, occluders, bounds, samples, points)) {
        mark_shadowed(samples, shadowed);
        return;
    }
    if (level == kCellLevels || !should_divide(cells, cell)) {
        test_cell(
            mesh, {samples, bounds, triangles, occluders.span()}, points, worker.kernel, shadowed);
        return;
    }
    IrregularCells& inner = worker.level[std::size_t(level)];
    const SampleRange all_samples{0, samples.size()}, all_triangles{0, triangles.size()};
    sort_into_cells(mesh, {samples, {&all_samples, 1}, samples.size(), bounds},
        {triangles, {&all_triangles, 1}}, inner, serial);
    if (inner.grid.cells() == 1) { // all samples have the same x and y
        test_cell(
            mesh, {samples, bounds, triangles, occluders.span()}, points, worker.kernel, shadowed);
        return;
    }
    for (std::size_t k = 0; k < std::size_t(inner.grid.cells()); ++k)
        test_or_divide(inner, k, level + 1);
}

/// Divides the patches into those that one triangle shadows as a whole (memory.occluded) and the
/// others (memory.remaining).
void find_occluded_patches(const PencilMesh& mesh, const PatchedSamples& patched,
    const PencilPoints& points, IrregularMemory& memory, Tasks& tasks)
{
    const auto patches = patched.patches;
    memory.occluded.resize(patches.size());
    memory.remaining.resize(patches.size());
    memory.is_occluded.resize(patches.size());
    memory.occluders = find_face_occluders(
        mesh, memory.triangle_ranges.span(), patched.bounds, memory.occluders_of_range, tasks);
    tasks.for_each(patches.size(), [&](std::size_t k, std::size_t) {
        const SamplePatch& patch = patches[k];
        const auto samples = memory.samples.subspan(patch.range.first, patch.range.count);
        memory.is_occluded[k] =
            !samples.empty() && is_occluded(mesh, memory.occluders, patch.bounds, samples, points);
    });
    std::size_t occluded = 0, remaining = 0;
    for (std::size_t k = 0; k < patches.size(); ++k) {
        if (patches[k].range.count == 0) continue;
        if (memory.is_occluded[k])
            memory.occluded[occluded++] = patches[k].range;
        else
            memory.remaining[remaining++] = patches[k];
    }
    memory.occluded.resize(occluded);
    memory.remaining.resize(remaining);
}

/// Divides memory.remaining into compact patches, which stay together (memory.patches), and samples
/// that are to be sorted into cells (memory.loose).
LooseSamples split_patches(
    const SampleBounds& bounds, std::size_t triangles, bool keep_compact, IrregularMemory& memory)
{
    const auto compact = [&](const SamplePatch& patch) {
        return keep_compact && is_compact(patch, bounds, triangles);
    };
    std::size_t all = 0, compact_samples = 0;
    for (const SamplePatch& patch : memory.remaining.span()) {
        all += patch.range.count;
        if (compact(patch)) compact_samples += patch.range.count;
    }
    // Binning the triangles into patches as well as into cells pays only for enough samples.
    const bool worth_it = 4 * compact_samples > all;

    LooseSamples left;
    left.array = memory.samples;
    std::size_t patches = 0, ranges = 0;
    memory.patches.patches.resize(memory.remaining.size());
    memory.loose.resize(memory.remaining.size());
    for (const SamplePatch& patch : memory.remaining.span()) {
        if (worth_it && compact(patch)) {
            memory.patches.patches[patches++] = patch;
        } else {
            memory.loose[ranges++] = patch.range;
            left.count += patch.range.count;
            left.bounds.add(patch.bounds);
        }
    }
    memory.patches.patches.resize(patches);
    memory.loose.resize(ranges);
    left.ranges = memory.loose.span();
    return left;
}

/// Gives every worker room for the largest patch and cell, so that nothing is allocated later on,
/// whichever worker takes it.
void prepare_workers(IrregularMemory& memory, int threads)
{
    while (int(memory.workers.size()) < threads)
        memory.workers.push_back(std::make_unique<CellWorker>());
    std::size_t samples = kManySamples; // of the largest cell or patch that is tested
    std::size_t triangles = 0;          // of the largest cell that is divided
    for (const SamplePatch& patch : memory.patches.patches.span())
        samples = std::max(samples, patch.range.count);
    std::size_t divided = 0;
    for (std::size_t cell = 0; cell < std::size_t(memory.cells.grid.cells()); ++cell) {
        const std::size_t count = memory.cells.samples_of(cell).size();
        samples = std::max(samples, count);
        if (!should_divide(memory.cells, cell)) continue;
        divided = std::max(divided, count);
        triangles = std::max(triangles, memory.cells.bins.of(cell).size());
    }
    for (const auto& worker : memory.workers) {
        reserve(worker->kernel, samples);
        IrregularCells& inner = worker->level[0];
        inner.samples.resize(divided, divided / 4);
        inner.cell_of.resize(divided + 16, divided / 4);
        inner.rect_of.resize(triangles + 16, triangles / 4);
        inner.bins.triangles.resize(2 * triangles, triangles);
        if (divided == 0) continue;
        for (auto* starts : {&inner.sample_start, &inner.bins.start})
            starts->resize(divided / kCellSamples + 2, 1024);
        for (auto* cursor : {&inner.cursor, &inner.bins.cursor})
            cursor->resize(divided / kCellSamples + 2, 4096);
    }
}

} // namespace

void sort_face(const PencilMesh& mesh, const PatchedSamples& patched, const PencilPoints& points,
    IrregularMemory& memory, Tasks& tasks)
{
    memory.samples = patched.samples;
    memory.triangle_ranges.resize(mesh.range_count.size());
    std::size_t count = 0;
    for (std::size_t k = 0; k < mesh.range_count.size(); ++k) {
        memory.triangle_ranges[k] = {k * kMeshRange, mesh.range_count[k]};
        count += mesh.range_count[k];
    }
    find_occluded_patches(mesh, patched, points, memory, tasks);

    const SampleBounds& bounds = patched.bounds;
    const TriangleRanges triangles{mesh.in_view.span(), memory.triangle_ranges.span()};
    LooseSamples loose = split_patches(bounds, count, true, memory);
    if (!bin_patches(triangles, bounds, memory.patches, tasks)) {
        // There are too many large triangles: sort all samples, into as few cells as necessary.
        loose = split_patches(bounds, count, false, memory);
        bin_patches(triangles, bounds, memory.patches, tasks);
    }
    sort_into_cells(mesh, loose, triangles, memory.cells, tasks);
}

void test_face(const PencilMesh& mesh, const PencilPoints& points, IrregularMemory& memory,
    Tasks& tasks, std::span<std::uint8_t> shadowed)
{
    prepare_workers(memory, tasks.threads());
    tasks.for_each(memory.occluded.size(), [&](std::size_t k, std::size_t) {
        const SampleRange& range = memory.occluded[k];
        mark_shadowed(memory.samples.subspan(range.first, range.count), shadowed);
    });
    const PatchMemory& patches = memory.patches;
    tasks.for_each(patches.patches.size(), [&](std::size_t k, std::size_t worker) {
        const SampleRange& range = patches.patches[k].range;
        const auto triangles = patches.bins.of(k);
        if (!triangles.empty())
            test_cell(mesh,
                {memory.samples.subspan(range.first, range.count), patches.patches[k].bounds,
                    triangles, memory.occluders.span()},
                points, memory.workers[worker]->kernel, shadowed);
    });
    const IrregularCells& cells = memory.cells;
    tasks.for_each(std::size_t(cells.grid.cells()), [&](std::size_t cell, std::size_t worker) {
        const CellTester tester{
            mesh, memory.occluders, points, shadowed, *memory.workers[worker], memory.serial};
        tester.test_or_divide(cells, cell, 0);
    });
}

} // namespace firsthit
