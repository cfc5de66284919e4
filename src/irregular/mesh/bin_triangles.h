// bin_triangles.h - copies each triangle to every bin it belongs to: a parallel counting sort in
// three passes (count, prefix sum, copy). A bin is a cell of a grid or a patch of samples.
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"
#include "irregular/mesh/pencil_mesh.h"
#include "irregular/mesh/samples.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace firsthit {

/// Divides a list of ranges into shares of consecutive ranges, one share a task. Each share has its
/// own counters, one a bin; with at most four shares a thread the counters stay fewer than the
/// triangles or samples to be sorted.
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

/// The prefix sum between the two passes.
///
/// cursor   (shares, bins) in: how many entries each share has for each bin; out: the index at
///          which the share writes its first entry of that bin
/// start    (bins + 1) out: the index at which each bin starts; the last element is the total
/// returns  the total number of entries
std::uint64_t start_bins(std::size_t shares, std::size_t bins, Buffer<std::uint32_t>& cursor,
    Buffer<std::uint32_t>& start);

/// Triangles sorted by bin; within a bin they keep their order. The memory is kept from frame to
/// frame.
struct TriangleBins {
    Buffer<ProjectedTriangle> triangles;
    Buffer<std::uint32_t> start;  // (bins + 1)
    Buffer<std::uint32_t> cursor; // (shares, bins) used only while sorting

    std::span<const ProjectedTriangle> of(std::size_t bin) const
    {
        return triangles.span().subspan(start[bin], start[bin + 1] - start[bin]);
    }
};

/// Some triangles of an array.
struct TriangleRanges {
    std::span<const ProjectedTriangle> array;
    std::span<const SampleRange> ranges; // of indices into `array`
};

/// Sorts triangles into `bins` bins.
///
/// for_bins  for_bins(k, f) calls f(bin) for each bin of from.array[k], the same bins at every call
/// returns   false, and sorts nothing, if that took far more than a few copies a triangle. With one
///           bin it never returns false
template <class ForBins>
bool bin_triangles(const TriangleRanges& from, std::size_t bins, const ForBins& for_bins,
    TriangleBins& out, Tasks& tasks)
{
    const auto array = from.array;
    const auto ranges = from.ranges;
    // The limit is four copies a triangle and 2^24 more (400 MB of memory).
    constexpr std::uint64_t kManyCopies = std::uint64_t(1) << 24;
    constexpr std::uint64_t kMostCopies = 0xFFFFFFFF; // cursors have 32 bits
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
    const std::uint64_t most = std::min(kManyCopies + 4 * array.size(), kMostCopies);
    if (total > most && bins > 1) return false;
    // The spare room avoids that a moving scene, which needs a little more now and then,
    // reallocates.
    out.triangles.resize(total, total + 2 * array.size());
    tasks.for_each(shares.count, [&](std::size_t share, std::size_t) {
        std::uint32_t* cursor = &out.cursor[share * bins];
        ProjectedTriangle* to = out.triangles.data();
        for (const SampleRange& range : shares.of(ranges, share))
            for (std::size_t k = range.first; k < range.first + range.count; ++k)
                for_bins(k, [=](std::size_t bin) { to[cursor[bin]++] = array[k]; });
    });
    return true;
}

} // namespace firsthit
