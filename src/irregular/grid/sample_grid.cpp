// sample_grid.cpp - sorts samples into the strips and cells of a grid, by two counting sorts.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "irregular/grid/sample_grid.cpp"
#include "base/simd.h"

#include "irregular/grid/quantized_points-inl.h"
#include "irregular/grid/sample_grid.h"
#include "irregular/mesh/project_lanes_to_face-inl.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Reals = hn::CappedTag<float, 16>;
using Halves = hn::RebindToUnsigned<Reals>;

/// Quantizes a register of x and y, and stores words of QuantizedPoint. w is already quantized.
template <class V, class W>
HWY_INLINE void store_quantized(const GridAxes& axes, V x, V y, W w, std::uint64_t* to)
{
    const Halves d;
    const auto along_x = quantize(axes.x, 65535.0f, x), along_y = quantize(axes.y, 65535.0f, y);
    const auto xy = axes.transposed ? hn::Or(along_y, hn::ShiftLeft<16>(along_x))
                                    : hn::Or(along_x, hn::ShiftLeft<16>(along_y));
    hn::StoreInterleaved2(
        hn::BitCast(d, w), hn::BitCast(d, xy), d, reinterpret_cast<std::uint32_t*>(to));
}

/// to[k] = the word of sample k. Writes whole registers; up to 15 entries past the last one are
/// garbage.
void quantize_samples(
    const GridAxes& axes, std::span<const IrregularSample> samples, std::uint64_t* to)
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
        store_quantized(axes, x, y, quantize(axes.w, 65534.0f, w), to + k);
    }
}

void quantize_corners(const GridAxes& axes, const CubeFace& face, const glm::vec3* corner,
    std::size_t count, QuantizedPoint* to)
{
    const Reals d;
    const hn::RebindToSigned<Reals> whole;
    const std::size_t lanes = hn::Lanes(d);
    for (std::size_t v = 0; v < count; v += lanes) {
        const std::size_t some = std::min(lanes, count - v);
        const float* from = &corner[v].x;
        glm::vec3 last[16];
        if (some < lanes) {
            for (std::size_t k = 0; k < lanes; ++k) last[k] = corner[std::min(v + k, count - 1)];
            from = &last[0].x;
        }
        auto px = hn::Zero(d), py = px, pz = px;
        hn::LoadInterleaved3(d, from, px, py, pz);
        const ProjectedLanes<Reals> projected = project_lanes_to_face(d, face, px, py, pz);
        const auto w = hn::IfThenElse(hn::RebindMask(whole, projected.valid),
            quantize(axes.w, 65534.0f, projected.w), hn::Set(whole, kQuantizedMax));
        if (some == lanes) {
            store_quantized(
                axes, projected.x, projected.y, w, reinterpret_cast<std::uint64_t*>(to + v));
        } else {
            std::uint64_t words[16];
            store_quantized(axes, projected.x, projected.y, w, words);
            std::memcpy(to + v, words, some * sizeof words[0]);
        }
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(quantize_samples);
HWY_EXPORT(quantize_corners);

namespace {

// The height of a strip. Measured: higher strips have longer runs, lower ones cut more triangles.
constexpr double kStripHeight = 3;                                           // in sample distances
constexpr double kWanted = kStripHeight * kStripHeight * double(kStripRows); // samples * rows
constexpr std::uint64_t kSpareWord = 1u << 16; // `unused` is 1, so it is in no box

GridAxes axes_of(const SampleBounds& bounds, bool transposed)
{
    const auto axis = [](float low, float high) {
        const float scale = 65533.0f / (high - low);
        return std::isfinite(scale) && std::isfinite(low) ? GridAxes::Axis{low, scale}
                                                          : GridAxes::Axis{};
    };
    return {axis(bounds.x0, bounds.x1), axis(bounds.y0, bounds.y1),
        axis(bounds.farthest_w, bounds.nearest_w), transposed};
}

/// Sets grid.error_shift and grid.error_rest.
///
/// A quantized coordinate is off by 1/2, because it is rounded to a whole number; by three
/// roundings of numbers up to 2^16 (0.02); and, in a pencil with an origin, by the rounding of the
/// coordinate itself. A difference of two coordinates is off by at most twice the sum, d, and so an
/// edge (b - a) x (p - a) by at most 2 d S + 2 d^2. d is rounded up to 1.25 times a power of 2.
void find_errors(const SampleBounds& bounds, bool directional, SampleGrid& grid)
{
    const auto off = [&](const GridAxes::Axis& axis, float low, float high) {
        const double largest = std::max(std::abs(double(low)), std::abs(double(high)));
        const double rounded = directional ? 0 : 0x1p-24 * 1.01 * largest * double(axis.scale);
        return 0.5 + 0.02 + rounded;
    };
    const double most = 2 * std::max(off(grid.axes.x, bounds.x0, bounds.x1),
                                off(grid.axes.y, bounds.y0, bounds.y1));
    constexpr int kMostShift = 8;
    grid.error_shift = 0;
    while (grid.error_shift < kMostShift && !(most <= std::ldexp(1.25, grid.error_shift)))
        ++grid.error_shift;
    const bool fits = most <= std::ldexp(1.25, grid.error_shift);
    grid.error_rest = fits ? 4u << 2 * grid.error_shift : 1u << 30;
}

/// Divides the rows into strips, and computes where each share writes its samples of each strip,
/// from row_counts (shares, rows). Returns the number of samples.
///
/// Let h rows of width w have n samples. If these fill them evenly, their distance is sqrt(h w /
/// n). A strip is to be k = kStripHeight of these distances high, which it is where n h = k^2 w. So
/// strips are lower where samples are dense.
std::size_t divide_rows(std::size_t shares, SampleGrid& grid)
{
    grid.strip_of.resize(kStripRows);
    std::size_t strip = 0, samples = 0, rows = 0;
    for (std::size_t row = 0; row < kStripRows; ++row) {
        std::size_t here = 0;
        for (std::size_t s = 0; s < shares; ++s) here += grid.row_counts[s * kStripRows + row];
        if (samples > 0 && (double(samples) + 0.5 * double(here)) * (double(rows) + 0.5) > kWanted)
            ++strip, samples = rows = 0;
        samples += here;
        rows += samples > 0;
        grid.strip_of[row] = std::uint16_t(strip);
    }
    const std::size_t strips = strip + 1;
    grid.cursor.resize(shares * strips, shares * strips / 4);
    std::fill_n(grid.cursor.data(), shares * strips, 0u);
    for (std::size_t s = 0; s < shares; ++s)
        for (std::size_t row = 0; row < kStripRows; ++row)
            grid.cursor[s * strips + grid.strip_of[row]] += grid.row_counts[s * kStripRows + row];
    grid.strips.resize(strips, strips / 4);
    std::uint32_t next = 0, cell = 0;
    for (std::size_t k = 0; k < strips; ++k) {
        const std::uint32_t sample = next;
        for (std::size_t s = 0; s < shares; ++s) {
            const std::uint32_t count = grid.cursor[s * strips + k];
            grid.cursor[s * strips + k] = next;
            next += count;
        }
        const std::uint32_t count = next - sample;
        const std::uint32_t columns = std::min(32768u, std::bit_floor(std::max(1u, count)));
        grid.strips[k] = {cell, 17u - std::uint32_t(std::bit_width(columns)), sample, count};
        cell += columns + 1;
    }
    grid.start.resize(cell, cell / 4);
    return next;
}

/// Finds the smallest w of each kDepthColumns-th part of a strip; kQuantizedMax where there is no
/// sample.
void find_farthest(std::size_t number, SampleGrid& grid)
{
    const GridStrip& strip = grid.strips[number];
    std::uint16_t* const farthest = &grid.farthest[number * kDepthColumns];
    std::fill_n(farthest, kDepthColumns, kQuantizedMax);
    for (std::uint32_t k = strip.sample; k < strip.sample + strip.count; ++k) {
        const std::uint64_t point = grid.quantized[k];
        std::uint16_t& least = farthest[point >> (32 + kDepthShift) & (kDepthColumns - 1)];
        least = std::min(least, std::uint16_t(point));
    }
    for (std::size_t k = 0; k + 1 < kDepthColumns; ++k)
        farthest[k] = std::min(farthest[k], farthest[k + 1]);
}

/// Sorts the samples of one strip by cell.
void sort_strip(std::size_t number, SampleGrid& grid)
{
    const GridStrip strip = grid.strips[number];
    const std::uint32_t first = strip.sample, last = first + strip.count;
    std::uint16_t* const start = &grid.start[strip.first];
    std::uint16_t* const cursor = start + 1;
    const std::size_t columns = 65536u >> strip.shift;
    const auto column = [&](std::uint64_t point) {
        return std::uint32_t(point >> 32 & 0xFFFF) >> strip.shift;
    };
    std::fill_n(start, columns + 1, std::uint16_t(0));
    for (std::uint32_t k = first; k < last; ++k) ++cursor[column(grid.by_strip[k].quantized)];
    std::uint32_t next = 0;
    std::uint64_t squares = 0;
    for (std::size_t c = 0; c < columns; ++c) {
        const std::uint32_t count = cursor[c];
        cursor[c] = std::uint16_t(next);
        next += count;
        squares += std::uint64_t(count) * count;
    }
    grid.squares[number] = double(squares);
    for (std::uint32_t k = first; k < last; ++k) {
        const SortedSample& sample = grid.by_strip[k];
        const std::uint32_t to = first + cursor[column(sample.quantized)]++;
        grid.quantized[to] = sample.quantized;
        grid.item[to] = sample.item;
        grid.sample_index[to] = sample.sample_index;
    }
}

double find_crowding(std::size_t samples, const SampleGrid& grid)
{
    const double total = std::max(1.0, double(samples));
    double cells = 0, rows = 0;
    for (std::size_t k = 0; k < grid.strips.size(); ++k) {
        const double count = grid.strips[k].count;
        cells += grid.squares[k];
        rows += count * count;
    }
    return cells / total + rows / (total * std::sqrt(total));
}

} // namespace

void quantize_vertices(const GridAxes& axes, const CubeFace& face, const glm::vec3* corner,
    std::size_t count, QuantizedPoint* quantized)
{
    HWY_DYNAMIC_DISPATCH(quantize_corners)(axes, face, corner, count, quantized);
}

bool sort_into_grid(const PatchedSamples& patched, const GridLayout& view,
    const PencilPoints& points, SampleGrid& grid, Tasks& tasks)
{
    const auto samples = patched.samples;
    const auto patches = patched.patches;
    const SampleBounds& bounds = patched.bounds;
    grid.bounds = bounds;
    grid.axes = axes_of(bounds, view.transposed);
    grid.samples = samples;
    find_errors(bounds, view.directional, grid);
    const Shares shares(patches.size(), std::size_t(tasks.threads()));
    grid.unsorted.resize(samples.size() + SampleGrid::kSpare);
    grid.row_counts.resize(shares.count * kStripRows);
    tasks.for_each(shares.count, [&](std::size_t share, std::size_t) {
        std::uint32_t* counts = &grid.row_counts[share * kStripRows];
        std::fill_n(counts, kStripRows, 0u);
        for (const SamplePatch& patch : shares.of(patches, share)) {
            std::uint64_t* point = &grid.unsorted[patch.range.first];
            HWY_DYNAMIC_DISPATCH(quantize_samples)
            (grid.axes, samples.subspan(patch.range.first, patch.range.count), point);
            for (std::size_t k = 0; k < patch.range.count; ++k)
                ++counts[point[k] >> (48 + kStripShift)];
        }
    });

    const std::size_t total = divide_rows(shares.count, grid), strips = grid.strips.size();
    for (const GridStrip& strip : grid.strips.span()) {
        if (strip.count <= 65535) continue;
        grid.crowding = std::numeric_limits<double>::infinity();
        return false;
    }
    grid.by_strip.resize(total, total / 4);
    tasks.for_each(shares.count, [&](std::size_t share, std::size_t) {
        std::uint32_t* cursor = &grid.cursor[share * strips];
        for (const SamplePatch& patch : shares.of(patches, share)) {
            for (std::size_t k = patch.range.first; k < patch.range.first + patch.range.count;
                 ++k) {
                const std::uint64_t point = grid.unsorted[k];
                const std::uint32_t item =
                    points.item ? points.item[samples[k].id] : std::uint32_t(kNoItem);
                grid.by_strip[cursor[grid.strip_of[point >> (48 + kStripShift)]]++] = {
                    point, item, std::uint32_t(k)};
            }
        }
    });

    grid.quantized.resize(total + SampleGrid::kSpare, total / 4);
    grid.item.resize(total + SampleGrid::kSpare, total / 4);
    grid.sample_index.resize(total, total / 4);
    grid.squares.resize(strips, strips / 4);
    grid.farthest.resize(strips * kDepthColumns, strips * kDepthColumns / 4);
    tasks.for_each(strips, [&](std::size_t strip, std::size_t) {
        sort_strip(strip, grid);
        find_farthest(strip, grid);
    });
    std::fill_n(&grid.quantized[total], SampleGrid::kSpare, kSpareWord);
    std::fill_n(&grid.item[total], SampleGrid::kSpare, std::uint32_t(kNoItem));
    grid.crowding = find_crowding(total, grid);
    return true;
}

} // namespace firsthit
#endif
