// grid_shadows.cpp - tests triangles against the samples of a grid.
//
// A triangle looks up the runs of samples that its box overlaps, mostly one or two, and tests a
// register of samples at a time in quantized coordinates: is the sample in the box, not in front of
// the whole triangle, not outside of an edge, and is its item another triangle? The few pairs that
// pass, mostly at edges, are decided in decide_pairs-inl.h.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "irregular/grid/grid_shadows.cpp"
#include "base/simd.h"

#include "irregular/grid/grid_boxes-inl.h"
#include "irregular/grid/grid_clusters-inl.h"
#include "irregular/grid/grid_shadows.h"
#include "irregular/grid/decide_pairs-inl.h"

#include <algorithm>
#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

constexpr std::uint32_t kEight = 8;          // samples that are tested together
constexpr std::uint32_t kMostSamples = 4096; // triangles over more samples are left to the cells

/// A batch of triangles. Each step is done for all triangles of the batch and writes a list for the
/// next step, which avoids branches that are hard to predict.
struct GridBatch {
    /// A triangle and eight consecutive samples that it is to be tested against.
    struct Candidate {
        std::uint32_t number; // of the triangle in the batch
        std::uint32_t first;  // index of the first sample
    };
    static constexpr std::size_t kMaxCandidates = 4 * GridBoxes::kTriangles;
    static constexpr std::size_t kCapacity = kMaxCandidates + 2;

    GridBoxes boxes;
    GridClusters clusters;
    GridPairs pairs;
    std::size_t candidate_count = 0, second_count = 0, wide_count = 0;
    Candidate candidate[kCapacity];

    // Indices into boxes.inside.
    std::uint32_t second[GridBoxes::kCapacity];   // triangles that overlap a second strip
    std::uint32_t wide[2 * GridBoxes::kCapacity]; // triangles over many strips or samples

    // Of the candidates
    std::uint32_t found[kCapacity];     // candidates of which a sample may be shadowed
    std::uint8_t found_bits[kCapacity]; // which of the eight samples
};

/// Bit k is set if the triangle may shadow the candidate's sample k.
HWY_INLINE std::uint32_t test_candidate(
    const GridTest& test, const GridBoxes& boxes, const GridBatch::Candidate& candidate)
{
    const Words d;
    const std::size_t i = candidate.number;
    const auto set = [&](const std::uint64_t& v) { return hn::Set(d, v); };
    const Word low = set(boxes.low[i]), high = set(boxes.high[i]), a = set(boxes.corner[0][i]);
    const GridEdges edges{
        {set(boxes.normal[0][i]), set(boxes.normal[1][i]), set(boxes.normal[2][i])},
        set(boxes.beyond[i]), set(boxes.beyond_opposite[i])};
    const hn::Rebind<std::uint32_t, Words> d32;
    const auto own = hn::Set(d32, std::uint32_t(boxes.first + i));
    std::uint32_t found = 0;
    for (std::uint32_t k = 0; k < kEight; k += std::uint32_t(hn::Lanes(d))) {
        const Word sample = hn::LoadU(d, test.grid.quantized.data() + candidate.first + k);
        const auto item = hn::LoadU(d32, test.grid.item.data() + candidate.first + k);
        const Word in_box = greatest16(least16(sample, high), low);
        const auto inside =
            hn::AndNot(edges.outside(difference16(sample, a)), hn::Eq(in_box, sample));
        found |= (bits_of_words(inside) & std::uint32_t(bits(d32, hn::Ne(item, own)))) << k;
    }
    return found;
}

/// Tests all candidates, adds the pairs that pass to batch.pairs, and empties the list of
/// candidates.
HWY_NOINLINE void test_candidates(GridTest& test, GridBatch& batch)
{
    std::size_t found = 0;
    for (std::size_t k = 0; k < batch.candidate_count; ++k) {
        const std::uint32_t chosen = test_candidate(test, batch.boxes, batch.candidate[k]);
        batch.found[found] = std::uint32_t(k);
        batch.found_bits[found] = std::uint8_t(chosen);
        found += chosen != 0;
    }
    GridPairs& pairs = batch.pairs;
    for (std::size_t k = 0; k < found; ++k) {
        const GridBatch::Candidate& candidate = batch.candidate[batch.found[k]];
        const std::uint32_t triangle = std::uint32_t(batch.boxes.first) + candidate.number;
        for (std::uint32_t rest = batch.found_bits[k]; rest; rest &= rest - 1) {
            pairs.triangle[pairs.count] = triangle;
            pairs.sample[pairs.count++] = candidate.first + std::uint32_t(std::countr_zero(rest));
        }
        if (pairs.count >= GridPairs::kMost) [[unlikely]]
            decide_pairs(test, pairs);
    }
    test.counts.pairs += batch.candidate_count * kEight;
    batch.candidate_count = 0;
}

/// Adds the samples of a run to the candidates. Returns false, and adds nothing, if there are more
/// than 16.
HWY_INLINE bool add_run(const SampleGrid& grid, std::uint32_t i, GridRun run, GridBatch& batch)
{
    const std::uint32_t count = run.last - run.first;
    if (count > 2 * kEight) [[unlikely]]
        return false;
    __builtin_prefetch(&grid.quantized[run.first]);
    __builtin_prefetch(&grid.quantized[run.first + kEight - 1]);
    __builtin_prefetch(&grid.item[run.first]);
    GridBatch::Candidate* const to = batch.candidate + batch.candidate_count;
    to[0] = {i, run.first};
    to[1] = {i, run.first + kEight};
    batch.candidate_count += std::size_t(count > 0) + std::size_t(count > kEight);
    return true;
}

/// Adds candidates for all triangles that overlap at most two strips and few samples: first those
/// of all triangles' first strips, then those of the second ones. Lists the other triangles in
/// batch.wide.
HWY_NOINLINE void look_up_runs(GridTest& test, GridBatch& batch)
{
    const SampleGrid& grid = test.grid;
    const GridBoxes& boxes = batch.boxes;
    batch.wide_count = batch.second_count = 0;
    for (std::size_t k = 0; k < boxes.inside_count; ++k) {
        const std::uint32_t i = boxes.inside[k];
        const std::uint64_t low = boxes.low[i], high = boxes.high[i];
        const StripRange strips = boxes.strips[k];
        const GridRun run = run_of(grid, strips.first, low, high);
        if (strips.last - strips.first > 1 || !add_run(grid, i, run, batch)) [[unlikely]] {
            batch.wide[batch.wide_count++] = std::uint32_t(k);
            continue;
        }
        batch.second[batch.second_count] = std::uint32_t(k);
        batch.second_count += strips.last != strips.first;
    }
    for (std::size_t k = 0; k < batch.second_count; ++k) {
        const std::uint32_t i = boxes.inside[batch.second[k]];
        const std::uint32_t strip = boxes.strips[batch.second[k]].last;
        const GridRun run = run_of(grid, strip, boxes.low[i], boxes.high[i]);
        if (!add_run(grid, i, run, batch)) [[unlikely]]
            batch.wide[batch.wide_count++] = batch.second[k];
    }
}

/// Adds candidates for a triangle over many strips or samples. Returns false, and adds nothing, if
/// it overlaps more than about kMostSamples samples.
bool look_up_wide_box(GridTest& test, GridBatch& batch, std::uint32_t k)
{
    const std::uint32_t i = batch.boxes.inside[k];
    const std::uint64_t low = batch.boxes.low[i], high = batch.boxes.high[i];
    const StripRange strips = batch.boxes.strips[k];
    static_assert(2 * kMostSamples / kEight <= GridBatch::kMaxCandidates);
    if (batch.candidate_count + kMostSamples / kEight > GridBatch::kMaxCandidates)
        test_candidates(test, batch);
    const std::size_t before = batch.candidate_count;
    std::uint32_t samples = 0;
    for (std::uint32_t strip = strips.first; strip <= strips.last; ++strip) {
        const GridRun run = run_of(test.grid, strip, low, high);
        samples += run.last - run.first + kEight;
        if (samples > kMostSamples) {
            batch.candidate_count = before;
            return false;
        }
        for (std::uint32_t first = run.first; first < run.last; first += kEight) {
            __builtin_prefetch(&test.grid.quantized[first]);
            batch.candidate[batch.candidate_count++] = {i, first};
        }
    }
    return true;
}

/// The projection of a triangle whose corners are all in front of the face and usable.
ProjectedTriangle project_triangle(const PencilMesh& mesh, std::uint32_t triangle)
{
    const Corners corners = mesh.corners(triangle);
    ProjectedPoint p[3];
    project_vertices_to_face(mesh.face, corners.data(), 3, p);
    return {triangle, std::min({p[0].x, p[1].x, p[2].x}), std::min({p[0].y, p[1].y, p[2].y}),
        std::max({p[0].x, p[1].x, p[2].x}), std::max({p[0].y, p[1].y, p[2].y}),
        std::max({p[0].w, p[1].w, p[2].w})};
}

void test_range(PencilMesh& mesh, std::size_t range, const GridSamples& samples, TestCounts& counts)
{
    const SampleGrid& grid = samples.grid;
    const std::size_t first = range * kMeshRange,
                      last = std::min(mesh.index.size(), first + kMeshRange);
    ProjectedTriangle* left = &mesh.in_view[first];
    GridTest test{mesh, grid, samples.points, samples.shadowed.data(), {}};
    GridBatch batch;
    for (std::size_t t = first; t < last; t += GridBoxes::kTriangles) {
        const std::size_t end = std::min(last, t + GridBoxes::kTriangles);
        find_boxes(mesh, t, end, batch.boxes);
        if (batch.clusters.backoff.should_try()) {
            const std::size_t wide = test_clusters(grid, end - t, batch.boxes, batch.clusters);
            batch.clusters.backoff.record(2 * GridClusters::kSize * wide <= end - t);
            test_clusters(test, batch.boxes, batch.clusters, batch.pairs);
        }
        sort_boxes(grid, batch.boxes);
        test.counts.triangles += batch.boxes.inside_count;
        look_up_runs(test, batch);
        for (std::size_t k = 0; k < batch.wide_count; ++k)
            if (!look_up_wide_box(test, batch, batch.wide[k]))
                *left++ =
                    project_triangle(mesh, std::uint32_t(t + batch.boxes.inside[batch.wide[k]]));
        test_candidates(test, batch);
        for (std::size_t k = 0; k < batch.boxes.unprojected_count; ++k) {
            ProjectedTriangle unprojected{
                std::uint32_t(t + batch.boxes.unprojected[k]), 0, 0, 0, 0, 0};
            if (project_clipped(mesh.face, mesh.corners(unprojected.triangle), unprojected) &&
                may_hit(unprojected, grid.bounds))
                *left++ = unprojected;
        }
    }
    decide_pairs(test, batch.pairs);
    mesh.range_count[range] = std::uint32_t(left - &mesh.in_view[first]);
    counts.add(test.counts);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(test_range);

bool prefers_strips_along_y(
    const PencilMesh& mesh, const CubeFace& face, const SampleBounds& bounds)
{
    // Compares kAsked triangles with the one that follows kFar later.
    constexpr std::size_t kAsked = 256, kFar = 8;
    const std::size_t step = std::max<std::size_t>(1, mesh.index.size() / kAsked);
    float along_x = 0, along_y = 0;
    for (std::size_t t = 0; t + kFar < mesh.index.size(); t += step) {
        const glm::vec3 corner[2] = {
            mesh.corner[mesh.index[t].x], mesh.corner[mesh.index[t + kFar].x]};
        ProjectedPoint projected[2];
        project_vertices_to_face(face, corner, 2, projected);
        const float dx = std::abs(projected[1].x - projected[0].x),
                    dy = std::abs(projected[1].y - projected[0].y);
        if (!std::isfinite(dx + dy)) continue; // one of the two corners is not projected
        along_x += dx, along_y += dy;
    }
    return along_y * (bounds.x1 - bounds.x0) > along_x * (bounds.y1 - bounds.y0);
}

std::size_t test_grid(
    PencilMesh& mesh, const GridSamples& samples, std::span<GridTestCounts> counts, Tasks& tasks)
{
    tasks.for_each(mesh.range_count.size(), [&](std::size_t range, std::size_t worker) {
        HWY_DYNAMIC_DISPATCH(test_range)
        (mesh, range, samples, counts[worker].counts);
    });
    std::size_t left = 0;
    for (const std::uint32_t count : mesh.range_count.span()) left += count;
    return left;
}

} // namespace firsthit
#endif
