// grid_clusters-inl.h - tests clusters of eight consecutive triangles, which mostly lie close
// together, against the sample grid: the samples in the box around all eight are looked up once,
// and each is tested against all eight triangles, one triangle a lane.
#if defined(FIRSTHIT_IRREGULAR_GRID_GRID_CLUSTERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_IRREGULAR_GRID_GRID_CLUSTERS_INL_H_
#undef FIRSTHIT_IRREGULAR_GRID_GRID_CLUSTERS_INL_H_
#else
#define FIRSTHIT_IRREGULAR_GRID_GRID_CLUSTERS_INL_H_
#endif

#include <hwy/highway.h>

#include "irregular/grid/grid_boxes-inl.h"
#include "irregular/grid/decide_pairs-inl.h"

#include <bit>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The clusters of one batch of triangles.
struct GridClusters {
    static constexpr std::size_t kSize = 8; // triangles
    static constexpr std::size_t kClusters = GridBoxes::kTriangles / kSize;
    static constexpr std::uint32_t kMostSamples = 96; // in the runs, including those beside the box

    struct Cluster {
        std::uint64_t low, high; // the box around the boxes of all eight triangles
        std::uint32_t first;     // number of the first triangle in the batch
        GridRun run[2];
    };
    std::size_t count = 0;
    Cluster cluster[kClusters + 1];
    Backoff backoff;

    // Of one cluster: the samples in its box, and the triangles that may shadow each of them.
    static constexpr std::size_t kCapacity = kMostSamples + 2 * kSize;
    std::uint32_t sample[kCapacity];
    std::uint8_t found[kCapacity]; // bit k: triangle k of the cluster
};

/// The box around the boxes of triangles i to i + 7.
HWY_INLINE void box_around(
    const GridBoxes& boxes, std::size_t i, std::uint64_t& box_low, std::uint64_t& box_high)
{
    const Words d;
    constexpr std::size_t kLanes = hn::MaxLanes(d);
    Word low = hn::Load(d, boxes.low + i), high = hn::Load(d, boxes.high + i);
    for (std::size_t k = kLanes; k < GridClusters::kSize; k += kLanes) {
        low = least16(low, hn::Load(d, boxes.low + i + k));
        high = greatest16(high, hn::Load(d, boxes.high + i + k));
    }
    if constexpr (kLanes >= 8) {
        low = least16(low, hn::Reverse(d, low));
        high = greatest16(high, hn::Reverse(d, high));
    }
    if constexpr (kLanes >= 4) {
        low = least16(low, hn::Reverse4(d, low));
        high = greatest16(high, hn::Reverse4(d, high));
    }
    if constexpr (kLanes >= 2) {
        low = least16(low, hn::Reverse2(d, low));
        high = greatest16(high, hn::Reverse2(d, high));
    }
    box_low = hn::GetLane(low);
    box_high = hn::GetLane(high);
}

/// Looks up the samples around each cluster of the batch. Clusters that lie behind all samples
/// around them are dropped. The triangles of clusters that overlap more than two strips or too many
/// samples are left in boxes.inside, to be tested one by one. Returns the number of those clusters.
HWY_NOINLINE std::size_t test_clusters(
    const SampleGrid& grid, std::size_t triangles, GridBoxes& boxes, GridClusters& clusters)
{
    std::size_t wide = 0;
    clusters.count = 0;
    boxes.inside_count = 0;
    for (std::size_t i = 0; i < triangles; i += GridClusters::kSize) {
        GridClusters::Cluster& to = clusters.cluster[clusters.count];
        box_around(boxes, i, to.low, to.high);
        if (to.low > to.high) continue; // no triangle of the cluster overlaps the samples' bounds
        to.first = std::uint32_t(i);
        const StripRange strips = strips_of(grid, to.low, to.high);
        const GridRun run = run_of(grid, strips.first, to.low, to.high);
        GridRun second = run_of(grid, strips.last, to.low, to.high);
        if (strips.first == strips.last) second.last = second.first;
        const std::uint32_t samples = run.last - run.first + second.last - second.first;
        if (strips.last - strips.first > 1 || samples > GridClusters::kMostSamples) {
            ++wide;
            for (std::size_t k = i; k < i + GridClusters::kSize; ++k) {
                boxes.inside[boxes.inside_count] = std::uint32_t(k);
                boxes.inside_count += boxes.low[k] <= boxes.high[k];
            }
            continue;
        }
        if (is_behind(grid, strips, to.low, to.high)) continue;
        for (std::uint32_t k = 0; k < 32; k += 8)
            __builtin_prefetch(&grid.quantized[run.first + k]);
        for (std::uint32_t k = 0; k < 32; k += 16) __builtin_prefetch(&grid.item[run.first + k]);
        for (std::uint32_t k = 0; k < 16; k += 8)
            __builtin_prefetch(&grid.quantized[second.first + k]);
        __builtin_prefetch(&grid.item[second.first]);
        to.run[0] = run, to.run[1] = second;
        clusters.count += samples > 0;
    }
    return wide;
}

/// Fills in clusters.sample with the samples inside the cluster's box. Returns how many there are.
/// The code compresses indices instead of words, because Highway's compress of words copies a table
/// to the stack each time.
HWY_INLINE std::size_t choose_samples(
    const SampleGrid& grid, const GridClusters::Cluster& cluster, GridClusters& clusters)
{
    const Words d;
    const hn::Rebind<std::uint32_t, Words> d32;
    const Word low = hn::Set(d, cluster.low), high = hn::Set(d, cluster.high);
    const auto numbers = hn::Iota(d32, 0);
    std::size_t count = 0;
    for (const GridRun& run : cluster.run)
        for (std::uint32_t k = run.first; k < run.last; k += std::uint32_t(hn::Lanes(d))) {
            const Word sample = hn::LoadU(d, grid.quantized.data() + k);
            const auto inside = hn::Eq(greatest16(least16(sample, high), low), sample);
            const std::uint8_t byte[8] = {std::uint8_t(bits_of_words(inside))};
            hn::StoreU(hn::Compress(hn::Add(numbers, hn::Set(d32, k)), hn::LoadMaskBits(d32, byte)),
                d32, clusters.sample + count);
            count += std::size_t(std::popcount(byte[0]));
        }
    return count;
}

/// Tests the chosen samples against the triangles of a cluster: bit k of clusters.found[s] is set
/// if triangle k may shadow sample s and is not the triangle that the sample lies on.
HWY_INLINE void test_samples(const SampleGrid& grid, const GridBoxes& boxes, std::size_t first,
    std::size_t count, GridClusters& clusters)
{
    const Words d;
    const hn::Rebind<std::uint32_t, Words> d32;
    for (std::size_t k = 0; k < GridClusters::kSize; k += hn::Lanes(d)) {
        const std::size_t i = first + k;
        const auto load = [&](const std::uint64_t* from) { return hn::Load(d, from + i); };
        const Word low = load(boxes.low), high = load(boxes.high), a = load(boxes.corner[0]);
        const GridEdges edges =
            find_edges(grid, {a, load(boxes.corner[1]), load(boxes.corner[2])}, low, high);
        const auto own = hn::Add(hn::Iota(d32, 0), hn::Set(d32, std::uint32_t(boxes.first + i)));
        for (std::size_t s = 0; s < count; ++s) {
            const Word sample = hn::Set(d, grid.quantized[clusters.sample[s]]);
            const Word in_box = greatest16(least16(sample, high), low);
            const auto inside =
                hn::AndNot(edges.outside(difference16(sample, a)), hn::Eq(in_box, sample));
            const auto others = hn::Ne(own, hn::Set(d32, grid.item[clusters.sample[s]]));
            const std::uint32_t found = (bits_of_words(inside) & std::uint32_t(bits(d32, others)))
                                        << k;
            clusters.found[s] = std::uint8_t(k == 0 ? found : clusters.found[s] | found);
        }
    }
}

/// Tests all clusters that were looked up, and adds the pairs that are left to `pairs`.
HWY_NOINLINE void test_clusters(
    GridTest& test, const GridBoxes& boxes, GridClusters& clusters, GridPairs& pairs)
{
    for (std::size_t c = 0; c < clusters.count; ++c) {
        const GridClusters::Cluster& cluster = clusters.cluster[c];
        const std::size_t count = choose_samples(test.grid, cluster, clusters);
        if (count == 0) continue;
        test_samples(test.grid, boxes, cluster.first, count, clusters);
        test.counts.triangles += GridClusters::kSize;
        const std::uint32_t first = std::uint32_t(boxes.first) + cluster.first;
        std::size_t kept = 0;
        for (std::size_t s = 0; s < count; ++s) {
            const std::uint8_t found = clusters.found[s];
            clusters.sample[kept] = clusters.sample[s];
            clusters.found[kept] = found;
            kept += found != 0;
        }
        for (std::size_t s = 0; s < kept; ++s) {
            __builtin_prefetch(&test.grid.sample_index[clusters.sample[s]]);
            for (std::uint32_t rest = clusters.found[s]; rest; rest &= rest - 1) {
                pairs.triangle[pairs.count] = first + std::uint32_t(std::countr_zero(rest));
                pairs.sample[pairs.count++] = clusters.sample[s];
            }
            if (pairs.count >= GridPairs::kMost) [[unlikely]]
                decide_pairs(test, pairs);
        }
        test.counts.pairs += count * GridClusters::kSize;
    }
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
