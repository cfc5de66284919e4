// bin_triangles.h - copies triangles to all bins that they belong to: a counting sort in three passes.
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"
#include "irregular/mesh/pencil_mesh.h"
#include "irregular/mesh/samples.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace firsthit {

/// Consecutive ranges that one task takes, so that there are not many more counts than things to
/// sort.
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

/// From counts (shares, bins) to where each share writes its part of each bin, and where the bins
/// start. Returns the sum.
std::uint64_t start_bins(std::size_t shares, std::size_t bins, Buffer<std::uint32_t>& cursor,
    Buffer<std::uint32_t>& start);

/// Triangles by bin, in their order. Kept from frame to frame.
struct TriangleBins {
    Buffer<ProjectedTriangle> triangles;
    Buffer<std::uint32_t> start;  // (bins + 1)
    Buffer<std::uint32_t> cursor; // (shares, bins), while sorting

    std::span<const ProjectedTriangle> of(std::size_t bin) const
    {
        return triangles.span().subspan(start[bin], start[bin + 1] - start[bin]);
    }
};

/// ranges    into `from`
/// for_bins  for_bins(k, f) calls f(bin) for each of the bins of from[k]
/// returns   false where that would be far more than a few copies a triangle: nothing is sorted
template <class ForBins>
bool bin_triangles(std::span<const ProjectedTriangle> from, std::span<const SampleRange> ranges,
    std::size_t bins, const ForBins& for_bins, TriangleBins& out, Tasks& tasks)
{
    constexpr std::uint64_t kManyCopies = std::uint64_t(1) << 24; // beyond four a triangle: 400 MB
    constexpr std::uint64_t kMostCopies = 0xFFFFFFFF;             // numbered in 32 bits
    const Shares shares(ranges.size(), std::size_t(tasks.threads()));
    out.cursor.resize(shares.count * bins, shares.count * bins + 4096);
    tasks.for_each(shares.count, [&](std::size_t share, std::size_t) {
        std::uint32_t* counts = &out.cursor[share * bins];
        std::fill_n(counts, bins, 0u);
        for (const SampleRange& range : shares.of(ranges, share))
            for (std::size_t k = range.first; k < range.first + range.count; ++k)
                for_bins(k, [=](std::size_t bin) { ++counts[bin]; });
    });
    const std::uint64_t total = start_bins(shares.count, bins, out.cursor, out.start);
    const std::uint64_t most = std::min(kManyCopies + 4 * from.size(), kMostCopies);
    if (total > most && bins > 1) return false;
    out.triangles.resize(total, total + 2 * from.size()); // moving scenes need more now and then
    tasks.for_each(shares.count, [&](std::size_t share, std::size_t) {
        std::uint32_t* cursor = &out.cursor[share * bins];
        ProjectedTriangle* to = out.triangles.data();
        for (const SampleRange& range : shares.of(ranges, share))
            for (std::size_t k = range.first; k < range.first + range.count; ++k)
                for_bins(k, [=](std::size_t bin) { to[cursor[bin]++] = from[k]; });
    });
    return true;
}

} // namespace firsthit
