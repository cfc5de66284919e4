// lazy_items.cpp - the exact items of a few samples of a picture.
//
// For most triangles it is enough to compare their box with one or two words of bits. The others
// are tested against each listed sample in their box: in double with an error bound, and exactly
// where that does not decide.
#include "visibility/lazy_items.h"

#include "base/tile_order.h"
#include "exact/hit.h"
#include "visibility/bin/triangle_box.h"

#include <firsthit/scene.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

namespace firsthit {
namespace {

/// Bins of 8x8 samples, and the words of bits of one row of them.
struct BinGrid {
    std::size_t columns, rows, words;

    explicit BinGrid(const Pencil& pencil)
        : columns(std::size_t(pencil.width + kBlock - 1) / kBlock),
          rows(std::size_t(pencil.height + kBlock - 1) / kBlock),
          words((columns + 63) / 64)
    {
    }

    std::size_t bin_of(const ListedSample& sample) const
    {
        return sample.y / std::size_t(kBlock) * columns + sample.x / std::size_t(kBlock);
    }
};

/// Sorts the samples by bin.
void bin_samples(const BinGrid& grid, std::span<const ListedSample> samples, LazyMemory& memory)
{
    const std::size_t bins = grid.columns * grid.rows;
    memory.start.resize(bins + 1);
    memory.has_any.resize(grid.rows * grid.words);
    memory.order.resize(samples.size());
    memory.listed.resize(samples.size());
    std::uint32_t* start = memory.start.data();
    std::fill_n(start, bins + 1, 0u);
    std::fill_n(memory.has_any.data(), memory.has_any.size(), std::uint64_t(0));
    for (const ListedSample& sample : samples) {
        const std::size_t column = sample.x / std::size_t(kBlock),
                          row = sample.y / std::size_t(kBlock);
        memory.has_any[row * grid.words + column / 64] |= std::uint64_t(1) << column % 64;
        ++start[grid.bin_of(sample)];
    }
    // From counts to ends; filling from the back makes starts of them.
    for (std::size_t bin = 0, sum = 0; bin <= bins; ++bin) {
        sum += start[bin];
        start[bin] = std::uint32_t(sum);
    }
    for (std::size_t k = samples.size(); k-- > 0;) {
        const std::uint32_t at = --start[grid.bin_of(samples[k])];
        memory.order[at] = std::uint32_t(k);
        memory.listed[at] = samples[k];
    }
}

/// A triangle that can be hit, and its edge functions in double, positive inside.
struct EdgeFilter {
    Corners corners;
    std::array<glm::dvec3, 3> edge;
    std::array<double, 3> error; // bounds of an edge's error at any ray of the pencil

    /// Whether the ray along d hits the triangle.
    bool hits(const glm::vec3& d, Effort& effort) const
    {
        bool certain = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const double e = (edge[k].x * double(d.x) + edge[k].y * double(d.y)) + edge[k].z;
            if (e < -error[k]) return false;
            certain &= e > error[k];
        }
        return certain || is_hit(corners, d, effort);
    }
};

/// Nothing if no ray can hit the triangle.
std::optional<EdgeFilter> edge_filter(const Corners& corners, const Pencil& pencil, Effort& effort)
{
    if (!usable(corners)) return std::nullopt;
    const int facing = volume_sign(corners, effort);
    if (facing == 0) return std::nullopt;
    const glm::dvec2 reach = pencil.tile(0, 0).reach(pencil.width, pencil.height);
    EdgeFilter filter{corners, {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 a(corners[k]), b(corners[(k + 1) % 3]);
        const glm::dvec3 n(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
        filter.edge[k] = double(facing) * n;
        // Each term has four roundings, as in exact/hit.h; the bound is twice that.
        filter.error[k] =
            8 * kUlp * (std::abs(n.x) * reach.x + std::abs(n.y) * reach.y + std::abs(n.z));
    }
    return filter;
}

/// The search of one thread.
struct Search {
    const Pencil& pencil;
    const EyeMesh& mesh;
    const BinGrid& grid;
    const LazyMemory& memory;
    std::span<const std::uint32_t> after; // in the caller's order, or empty
    std::uint32_t* nearest;               // (samples) by bin
    Effort effort;

    glm::vec3 ray(const ListedSample& sample) const
    {
        return pencil.tile(0, 0).direction(sample.x, sample.y);
    }

    /// Replaces `best` by the triangle if it is nearer on the ray along d, which hits it.
    void offer(
        std::uint32_t triangle, const Corners& corners, const glm::vec3& d, std::uint32_t& best)
    {
        if (best == kNoItem) {
            best = triangle;
            return;
        }
        const int order = compare_depth(corners, corners_of(mesh, best), d, effort);
        if (order < 0 || (order == 0 && triangle < best)) best = triangle;
    }

    /// Whether a triangle counts for sample k, by bin, whose ray along d hits it.
    bool counts(std::uint32_t triangle, const Corners& corners, const glm::vec3& d, std::uint32_t k)
    {
        if (!mesh.cutouts.is_there(triangle, corners, d)) return false;
        if (after.empty()) return true;
        const std::uint32_t last = after[memory.order[k]];
        if (triangle == last) return false;
        const int order = compare_depth(corners, corners_of(mesh, last), d, effort);
        return order > 0 || (order == 0 && triangle > last);
    }

    /// Calls f(bin) for each bin that has samples and meets the box.
    template <class F>
    void for_bins(const InView& box, const F& f) const
    {
        const auto x0 = std::size_t(box.x0) / kBlock, x1 = std::size_t(box.x1) / kBlock;
        const auto y0 = std::size_t(box.y0) / kBlock, y1 = std::size_t(box.y1) / kBlock;
        const std::uint64_t from = ~std::uint64_t(0) << x0 % 64,
                            to = ~std::uint64_t(0) >> (63 - x1 % 64);
        for (std::size_t row = y0; row <= y1; ++row) {
            for (std::size_t word = x0 / 64; word <= x1 / 64; ++word) {
                std::uint64_t bins = memory.has_any[row * grid.words + word];
                if (word == x0 / 64) bins &= from;
                if (word == x1 / 64) bins &= to;
                for (; bins; bins &= bins - 1)
                    f(row * grid.columns + word * 64 + std::size_t(std::countr_zero(bins)));
            }
        }
    }

    /// Tests a triangle against all listed samples in its box.
    void test(std::uint32_t triangle)
    {
        InView box;
        if (!box_of(triangle, mesh, pencil, box)) return;
        std::optional<EdgeFilter> filter;
        bool seen = true;
        for_bins(box, [&](std::size_t bin) {
            for (std::uint32_t k = memory.start[bin]; seen && k < memory.start[bin + 1]; ++k) {
                const ListedSample& sample = memory.listed[k];
                if (sample.x < box.x0 || sample.x > box.x1 || sample.y < box.y0 ||
                    sample.y > box.y1)
                    continue;
                if (!filter) {
                    filter = edge_filter(corners_of(mesh, triangle), pencil, effort);
                    seen = filter.has_value();
                    if (!seen) return;
                }
                const glm::vec3 d = ray(sample);
                if (filter->hits(d, effort) && counts(triangle, filter->corners, d, k))
                    offer(triangle, filter->corners, d, nearest[k]);
            }
        });
    }
};

} // namespace

std::span<const std::uint32_t> find_listed_items(const Pencil& pencil, const EyeMesh& mesh,
    const ListedSamples& listed, LazyMemory& memory, Tasks& tasks)
{
    const auto samples = listed.samples;
    constexpr std::size_t kRange = 4096; // triangles of a task
    memory.effort = 0;
    memory.item.resize(samples.size());
    if (samples.empty()) return {};
    const BinGrid grid(pencil);
    bin_samples(grid, samples, memory);
    const auto threads = std::size_t(tasks.threads());
    memory.nearest.resize(threads * samples.size());
    memory.exact_calls.resize(threads);
    std::fill_n(memory.nearest.data(), memory.nearest.size(), kNoItem);
    std::fill_n(memory.exact_calls.data(), threads, std::uint64_t(0));

    const std::size_t triangles = mesh.index.size();
    tasks.for_each((triangles + kRange - 1) / kRange, [&](std::size_t range, std::size_t worker) {
        Search search{
            pencil, mesh, grid, memory, listed.after, &memory.nearest[worker * samples.size()], {}};
        const std::size_t last = std::min(triangles, (range + 1) * kRange);
        for (std::size_t t = range * kRange; t < last; ++t) search.test(std::uint32_t(t));
        memory.exact_calls[worker] += search.effort.exact_calls;
    });

    // Find the nearest of all threads' nearest triangles, which does not depend on what each of
    // them has tested.
    Search merge{pencil, mesh, grid, memory, {}, memory.nearest.data(), {}};
    for (std::size_t k = 0; k < samples.size(); ++k) {
        std::uint32_t& best = memory.nearest[k];
        for (std::size_t worker = 1; worker < threads; ++worker) {
            const std::uint32_t other = memory.nearest[worker * samples.size() + k];
            if (other == kNoItem) continue;
            merge.offer(other, corners_of(mesh, other), merge.ray(memory.listed[k]), best);
        }
        memory.item[memory.order[k]] = best;
    }
    memory.effort = merge.effort.exact_calls;
    for (std::size_t worker = 0; worker < threads; ++worker)
        memory.effort += memory.exact_calls[worker];
    return memory.item.span();
}

} // namespace firsthit
