// sample_grid.cpp - a counting sort of samples into coarse cells, then into those of one coarse cell.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visibility/sample_grid.cpp"
#include "base/simd.h"

#include "visibility/grid_places-inl.h"
#include "visibility/sample_grid.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#ifndef FIRSTHIT_SAMPLE_GRID_PLACES
#define FIRSTHIT_SAMPLE_GRID_PLACES
namespace firsthit {

/// The part of its cell that a place lies in, a bit.
inline std::uint64_t part_of(std::uint32_t place, std::uint32_t level)
{
    const std::uint32_t shift = kMostLevels - level;
    return std::uint64_t(1) << ((place >> (16 + shift) & 7) * 8 + (place >> shift & 7));
}

} // namespace firsthit
#endif

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Reals = hn::CappedTag<float, 16>;
using Places = hn::RebindToSigned<Reals>;

/// x + 65536 y.
template <class V>
HWY_INLINE auto places_of(const GridAxes& axes, V x, V y)
{
    return hn::Or(
        places_along(axes.x, 65535.0f, x), hn::ShiftLeft<16>(places_along(axes.y, 65535.0f, y)));
}

/// to[k] = x + 65536 y of sample k. Up to 15 more are written.
void place_given(const GridAxes& axes, std::span<const IrregularSample> samples, std::uint32_t* to)
{
    const Reals d;
    const std::size_t lanes = hn::Lanes(d);
    for (std::size_t k = 0; k < samples.size(); k += lanes) {
        const IrregularSample* from = &samples[k];
        IrregularSample last[16];
        if (k + lanes > samples.size()) {
            for (std::size_t i = 0; i < lanes; ++i)
                last[i] = samples[std::min(k + i, samples.size() - 1)];
            from = last;
        }
        auto x = hn::Zero(d), y = x, w = x, id = x;
        hn::LoadInterleaved4(d, &from->x, x, y, w, id);
        hn::StoreU(places_of(axes, x, y), Places(), reinterpret_cast<std::int32_t*>(to + k));
    }
}

/// The samples of a block.
struct BlockPlaces {
    alignas(64) std::uint32_t at[GridBlock::kSamples]; // x + 65536 y
    alignas(64) std::uint32_t w[GridBlock::kSamples];
};

HWY_INLINE void place_block(const GridAxes& axes, const GridBlock& block, BlockPlaces& places)
{
    const hn::CappedTag<float, GridBlock::kSamples> d;
    const hn::RebindToSigned<decltype(d)> i;
    for (std::size_t k = 0; k < GridBlock::kSamples; k += hn::Lanes(d)) {
        hn::Store(places_of(axes, hn::Load(d, block.x + k), hn::Load(d, block.y + k)), i,
            reinterpret_cast<std::int32_t*>(places.at + k));
        hn::Store(places_along(axes.w, 65534.0f, hn::Load(d, block.w + k)), i,
            reinterpret_cast<std::int32_t*>(places.w + k));
    }
}

/// Looks at the samples of all cells of a coarse cell, and fills up their last blocks.
/// end  (cells) the slots behind their last samples
void finish(CoarseCell& coarse, const std::uint32_t* end, SampleGrid& grid)
{
    constexpr std::uint32_t kSamples = GridBlock::kSamples;
    BlockPlaces places;
    coarse.farthest_w = kLastPlace;
    const std::size_t cells = std::size_t(1) << 2 * coarse.level;
    for (std::size_t c = coarse.first; c < coarse.first + cells; ++c) {
        std::uint64_t occupied = 0;
        std::uint32_t farthest = kLastPlace;
        for (std::uint32_t slot = grid.cells[c].first * kSamples; slot < end[c]; slot += kSamples) {
            GridBlock& block = grid.blocks[slot / kSamples];
            const std::uint32_t count = std::min(kSamples, end[c] - slot);
            for (std::uint32_t k = count; k < kSamples; ++k) {
                block.x[k] = std::numeric_limits<float>::infinity();
                block.y[k] = block.w[k] = 0;
                block.item[k] = kNoItem;
                grid.id[slot + k] = kNoSample;
            }
            place_block(grid.axes, block, places);
            for (std::uint32_t k = 0; k < count; ++k) {
                farthest = std::min(farthest, places.w[k]);
                occupied |= part_of(places.at[k], coarse.level);
            }
        }
        grid.cells[c].occupied = occupied;
        grid.cells[c].farthest_w = farthest;
        coarse.farthest_w = std::uint16_t(std::min<std::uint32_t>(coarse.farthest_w, farthest));
    }
}

/// Vertices whose x is no number are not seen.
void place_corners(const GridAxes& axes, const SeenPoint* seen, std::size_t count, GridPlace* to)
{
    const Reals d;
    const Places p;
    const std::size_t lanes = hn::Lanes(d);
    alignas(64) std::int32_t xy[16], w[16];
    SeenPoint last[16];
    for (std::size_t v = 0; v < count; v += lanes) {
        const std::size_t some = std::min(lanes, count - v);
        const SeenPoint* from = seen + v;
        if (some < lanes) {
            for (std::size_t k = 0; k < lanes; ++k) last[k] = seen[std::min(v + k, count - 1)];
            from = last;
        }
        auto x = hn::Zero(d), y = x, depth = x;
        hn::LoadInterleaved3(d, &from->x, x, y, depth);
        hn::Store(places_of(axes, x, y), p, xy);
        const auto nowhere = hn::RebindMask(p, hn::Not(hn::Eq(x, x)));
        hn::Store(
            hn::IfThenElse(nowhere, hn::Set(p, kLastPlace), places_along(axes.w, 65534.0f, depth)),
            p, w);
        for (std::size_t k = 0; k < some; ++k) {
            const std::uint64_t word =
                std::uint64_t(std::uint32_t(xy[k])) | std::uint64_t(std::uint32_t(w[k])) << 32;
            std::memcpy(to + v + k, &word, sizeof word);
        }
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(place_given);
HWY_EXPORT(finish);
HWY_EXPORT(place_corners);

namespace {

// Measured: with fewer a triangle meets too many cells, with more too many samples that it misses.
constexpr std::uint32_t kCellSamples = 32; // at most wanted in a cell
constexpr std::size_t kSpare = 16;         // samples nowhere, for a register's end
constexpr std::size_t kAfter =
    (1 << kMostLevels) + 3; // cells after the last: a row, and neighbours
constexpr std::size_t kAllCoarse = std::size_t(kCoarseCells) * kCoarseCells;

GridAxes axes_of(const SampleBounds& bounds)
{
    const auto axis = [](float low, float high) {
        const float scale = 65533.0f / (high - low);
        return std::isfinite(scale) && std::isfinite(low) ? GridAxes::Axis{low, scale}
                                                          : GridAxes::Axis{};
    };
    return {axis(bounds.x0, bounds.x1), axis(bounds.y0, bounds.y1),
        axis(bounds.farthest_w, bounds.nearest_w)};
}

std::uint32_t coarse_cell(std::uint32_t place)
{
    return (place >> (16 + kFineBits) << kCoarseBits) | ((place & 0xFFFF) >> kFineBits);
}

/// The cell of a place in a coarse cell of that level, from the coarse cell's first one.
std::uint32_t inner_cell(std::uint32_t place, std::uint32_t level)
{
    const std::uint32_t shift = kFineBits - level;
    return ((place >> 16 & kFineMask) >> shift << level) | ((place & kFineMask) >> shift);
}

/// From counts (shares, coarse cells) to levels and first cells. Returns the number of cells.
std::size_t divide_coarse(std::size_t shares, SampleGrid& grid)
{
    grid.coarse.resize(kAllCoarse);
    std::uint32_t next = 0;
    for (std::size_t cell = 0; cell < kAllCoarse; ++cell) {
        std::uint32_t samples = 0, level = 0;
        for (std::size_t s = 0; s < shares; ++s)
            samples += grid.coarse_counts[s * kAllCoarse + cell];
        while (level < std::uint32_t(kMostLevels) && samples >> (2 * level) > kCellSamples) ++level;
        grid.coarse[cell] = {next, std::uint16_t(level), 0};
        next += 1u << (2 * level);
    }
    return next;
}

/// From counts (shares, cells) to the slots where each share writes its samples of each cell, and to
/// the cells' first blocks. Returns the number of blocks.
std::uint32_t place_cells(std::size_t shares, std::size_t cells, SampleGrid& grid)
{
    constexpr std::uint32_t kSamples = GridBlock::kSamples;
    grid.cells.resize(cells + kAfter, cells / 4);
    std::uint32_t next = 0;
    double squares = 0, total = 0;
    for (std::size_t c = 0; c < cells; ++c) {
        const std::uint32_t first = next;
        grid.cells[c].first = first / kSamples;
        for (std::size_t s = 0; s < shares; ++s) {
            const std::uint32_t count = grid.cursor[s * cells + c];
            grid.cursor[s * cells + c] = next;
            next += count;
        }
        const double count = next - first;
        squares += count * count;
        total += count;
        next = (next + kSamples - 1) / kSamples * kSamples;
    }
    grid.crowding = squares / std::max(1.0, total);
    std::fill_n(&grid.cells[cells], kAfter, GridCell{0, next / kSamples, kLastPlace});
    return next / kSamples;
}

/// Copies the samples of some patches to their cells.
void move_samples(std::span<const IrregularSample> samples, std::span<const SamplePatch> patches,
    const LightPoints& points, std::uint32_t* cursor, SampleGrid& grid)
{
    for (const SamplePatch& patch : patches) {
        for (std::size_t k = patch.range.first; k < patch.range.first + patch.range.count; ++k) {
            const IrregularSample& sample = samples[k];
            const std::uint32_t to = cursor[grid.cell_of[k]]++, lane = to % GridBlock::kSamples;
            GridBlock& block = grid.blocks[to / GridBlock::kSamples];
            block.x[lane] = sample.x;
            block.y[lane] = sample.y;
            block.w[lane] =
                sample.w == sample.w ? sample.w : -std::numeric_limits<float>::infinity();
            block.item[lane] = points.item ? points.item[sample.id] : kNoItem;
            grid.id[to] = sample.id;
        }
    }
}

} // namespace

void place_vertices(
    const GridAxes& axes, const SeenPoint* seen, std::size_t count, GridPlace* places)
{
    HWY_DYNAMIC_DISPATCH(place_corners)(axes, seen, count, places);
}

void sort_into_grid(std::span<const IrregularSample> samples, std::span<const SamplePatch> patches,
    const SampleBounds& bounds, const LightPoints& points, SampleGrid& grid, Tasks& tasks)
{
    grid.bounds = bounds;
    grid.axes = axes_of(bounds);
    const Shares shares(patches.size(), std::size_t(tasks.threads()));
    grid.cell_of.resize(samples.size() + kSpare);
    grid.coarse_counts.resize(shares.count * kAllCoarse);
    tasks.for_each(shares.count, [&](std::size_t share, std::size_t) {
        std::uint32_t* counts = &grid.coarse_counts[share * kAllCoarse];
        std::fill_n(counts, kAllCoarse, 0u);
        for (const SamplePatch& patch : shares.of(patches, share)) {
            std::uint32_t* place = &grid.cell_of[patch.range.first];
            HWY_DYNAMIC_DISPATCH(place_given)
            (grid.axes, samples.subspan(patch.range.first, patch.range.count), place);
            for (std::size_t k = 0; k < patch.range.count; ++k) ++counts[coarse_cell(place[k])];
        }
    });

    const std::size_t cells = divide_coarse(shares.count, grid);
    grid.cursor.resize(shares.count * cells, shares.count * cells / 4);
    tasks.for_each(shares.count, [&](std::size_t share, std::size_t) {
        std::uint32_t* counts = &grid.cursor[share * cells];
        std::fill_n(counts, cells, 0u);
        for (const SamplePatch& patch : shares.of(patches, share)) {
            std::uint32_t* cell = &grid.cell_of[patch.range.first];
            for (std::size_t k = 0; k < patch.range.count; ++k) {
                const CoarseCell& coarse = grid.coarse[coarse_cell(cell[k])];
                cell[k] = coarse.first + inner_cell(cell[k], coarse.level);
                ++counts[cell[k]];
            }
        }
    });

    const std::size_t blocks = place_cells(shares.count, cells, grid);
    grid.blocks.resize(blocks, blocks / 4);
    grid.id.resize(blocks * GridBlock::kSamples, blocks * GridBlock::kSamples / 4);
    tasks.for_each(shares.count, [&](std::size_t share, std::size_t) {
        move_samples(samples, shares.of(patches, share), points, &grid.cursor[share * cells], grid);
    });
    const std::uint32_t* end = &grid.cursor[(shares.count - 1) * cells]; // by now
    tasks.for_each(kCoarseCells, [&](std::size_t row, std::size_t) {
        for (std::size_t k = row * kCoarseCells; k < (row + 1) * kCoarseCells; ++k)
            HWY_DYNAMIC_DISPATCH(finish)(grid.coarse[k], end, grid);
    });
}

} // namespace firsthit
#endif
