// grid_boxes-inl.h - boxes and edges of triangles in quantized coordinates, several triangles a
// register. quantized_points.h has a worked example.
#if defined(FIRSTHIT_IRREGULAR_GRID_GRID_BOXES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_IRREGULAR_GRID_GRID_BOXES_INL_H_
#undef FIRSTHIT_IRREGULAR_GRID_GRID_BOXES_INL_H_
#else
#define FIRSTHIT_IRREGULAR_GRID_GRID_BOXES_INL_H_
#endif

#include <hwy/highway.h>

#include "irregular/grid/grid_runs.h"
#include "irregular/mesh/pencil_mesh.h"
#include "irregular/grid/quantized_words-inl.h"
#include "irregular/grid/sample_grid.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

inline constexpr std::uint64_t kUpperHalf = 0xFFFFFFFF00000000;

/// Decides for which batches an optional step is tried: after each try that was not worthwhile, it
/// is skipped for twice as many batches (and one more), up to kLongest.
struct Backoff {
    static constexpr std::uint32_t kLongest = 15;
    std::uint32_t left = 0, next = 0;

    /// Whether to try the step for this batch.
    bool should_try()
    {
        if (left == 0) return true;
        --left;
        return false;
    }
    void record(bool worthwhile)
    {
        next = worthwhile ? 0 : std::min(2 * next + 1, kLongest);
        left = next;
    }
};

/// A batch of consecutive triangles, numbered from 0 on. Words are those of QuantizedPoint.
struct GridBoxes {
    static constexpr std::size_t kTriangles = 256;
    static constexpr std::size_t kCapacity = kTriangles + 16;

    std::size_t first = 0; // index of triangle 0 in the mesh
    alignas(64) std::uint64_t corner[3][kCapacity];
    // The triangle's box. The w of low is 0. low > high for a triangle that no sample is tested
    // against.
    alignas(64) std::uint64_t low[kCapacity];
    alignas(64) std::uint64_t high[kCapacity];

    /// Edge e of a sample is products16(sample - corner 0, normal[e]) + beyond, negative where the
    /// sample is certainly outside. Edge 1 is opposite of corner 0 and adds beyond_opposite
    /// instead. The lower halves of these words are 0.
    alignas(64) std::uint64_t normal[3][kCapacity];
    alignas(64) std::uint64_t beyond[kCapacity];          // edges 0 and 2: the error
    alignas(64) std::uint64_t beyond_opposite[kCapacity]; // edge 1: the error and twice the area

    Backoff backoff; // of remove_behind_samples

    // Lists of triangles of the batch.
    std::size_t inside_count = 0, unprojected_count = 0;
    std::uint32_t
        inside[kCapacity]; // may shadow samples; at first all that overlap the samples' bounds
    StripRange strips[kCapacity];         // of the triangles in `inside`
    std::uint32_t unprojected[kCapacity]; // with a corner that is behind the face or unusable
};

/// Appends first + k to the list for each chosen lane k. Writes a whole register; entries past
/// `count` are garbage.
HWY_INLINE void append(
    std::size_t first, hn::Mask<Words> chosen, std::uint32_t* to, std::size_t& count)
{
    const hn::Rebind<std::uint32_t, Words> d;
    const std::uint8_t byte[8] = {std::uint8_t(bits_of_words(chosen))};
    const auto lanes = hn::LoadMaskBits(d, byte);
    const auto numbers = hn::Add(hn::Iota(d, 0), hn::Set(d, std::uint32_t(first)));
    hn::StoreU(hn::Compress(numbers, lanes), d, to + count);
    count += hn::CountTrue(Words(), chosen);
}

/// Loads the quantized corners of triangles [first, last).
HWY_INLINE void gather_quantized_corners(
    const PencilMesh& mesh, std::size_t first, std::size_t last, GridBoxes& boxes)
{
    const glm::uvec3* const index = mesh.index.data() + first;
    const QuantizedPoint* const quantized = mesh.quantized.data();
    constexpr std::size_t kAhead =
        128; // triangles: how far ahead of the copy indices are prefetched
    const std::size_t ahead = std::min(kAhead, mesh.index.size() - last);
    for (std::size_t i = 0; i < last - first; ++i) {
        __builtin_prefetch(index + i + ahead);
        for (int k = 0; k < 3; ++k)
            std::memcpy(&boxes.corner[k][i], &quantized[index[i][k]], sizeof(QuantizedPoint));
    }
}

/// The edges of a register of triangles; see GridBoxes.
struct GridEdges {
    Word normal[3];
    Word beyond, beyond_opposite;

    /// The lanes whose sample is certainly outside of an edge.
    /// from  sample - corner 0
    HWY_INLINE hn::Mask<Words> outside(Word from) const
    {
        const Word e0 = hn::Add(products16(from, normal[0]), beyond),
                   e1 = hn::Add(products16(from, normal[1]), beyond_opposite),
                   e2 = hn::Add(products16(from, normal[2]), beyond);
        return below_zero(hn::Or(hn::Or(e0, e1), e2));
    }
};

/// The quantized corners of a register of triangles.
struct CornerWords {
    Word a, b, c;
};

/// Computes the edges of a register of triangles. They are 0, so that no sample is outside, where
///     the box is 2^14 or more wide or high: products would not fit into 32 bits; or
///     a corner lies beyond the samples' bounds: its quantized coordinate is clamped; or
///     |area| is not above the error: the triangle might be oriented the other way.
HWY_INLINE GridEdges find_edges(
    const SampleGrid& grid, const CornerWords& corners, Word low, Word high)
{
    const auto [a, b, c] = corners;
    const Words d;
    constexpr std::uint64_t kLarge = 0xC000C00000000000; // the bits of x or y that are 2^14 or more
    const auto set = [&](std::uint64_t v) { return hn::Set(d, v); };
    const Word zero = hn::Zero(d), upper = set(kUpperHalf);
    const Word size = difference16(high, low);
    const auto beyond_grid =
        hn::Or(any16(low, 0, kUpperHalf), any16(high, kQuantizedMax, kUpperHalf));
    const auto unfit = hn::Or(hn::Ne(hn::And(size, set(kLarge)), zero), beyond_grid);

    // The normal of the edge from p to q: (-dy, dx).
    const auto normal = [&](Word p, Word q) {
        const Word along = difference16(q, p), dx = hn::ShiftLeft<16>(along),
                   dy = hn::ShiftLeft<32>(hn::ShiftRight<48>(difference16(p, q)));
        return hn::Or(dy, hn::And(dx, set(0xFFFF000000000000)));
    };
    const Word n0 = normal(a, b), n1 = normal(b, c), n2 = normal(c, a);
    const Word area = products16(difference16(c, a), n0);
    // The error bound (SampleGrid::error_shift), in the upper half.
    const Word extent =
        hn::Add(hn::And(hn::ShiftRight<32>(size), set(0xFFFF)), hn::ShiftRight<48>(size));
    const Word two_and_a_half =
        hn::Add(hn::Add(extent, extent), hn::Add(hn::ShiftRight<1>(extent), set(1)));
    const Word error = hn::ShiftLeft<32>(
        hn::Add(hn::ShiftLeftSame(two_and_a_half, grid.error_shift), set(grid.error_rest)));

    const auto flipped = below_zero(area);
    const Word flip = hn::IfThenElseZero(flipped, upper);
    const Word side = hn::IfThenElse(flipped, hn::Sub(zero, area), area);
    // Only where |area| > error. No sum here leaves the 63 bits of a signed number.
    const auto certain = hn::AndNot(unfit, below_zero(hn::Sub(error, side)));
    const auto kept = [&](Word v) { return hn::IfThenElseZero(certain, v); };
    const auto inward = [&](Word n) { return kept(difference16(hn::Xor(n, flip), flip)); };
    return {{inward(n0), inward(n1), inward(n2)}, kept(error), kept(hn::Add(error, side))};
}

/// Computes the edges of the triangles 8 k to 8 k + 7 for each bit k that is set in `groups`.
HWY_NOINLINE inline void find_all_edges(
    const SampleGrid& grid, std::uint32_t groups, GridBoxes& boxes)
{
    const Words d;
    for (; groups; groups &= groups - 1) {
        const std::size_t first = 8 * std::size_t(std::countr_zero(groups));
        for (std::size_t i = first; i < first + 8; i += hn::Lanes(d)) {
            const auto load = [&](const std::uint64_t* from) { return hn::Load(d, from + i); };
            const GridEdges edges = find_edges(grid,
                {load(boxes.corner[0]), load(boxes.corner[1]), load(boxes.corner[2])},
                load(boxes.low), load(boxes.high));
            for (int e = 0; e < 3; ++e) hn::Store(edges.normal[e], d, boxes.normal[e] + i);
            hn::Store(edges.beyond, d, boxes.beyond + i);
            hn::Store(edges.beyond_opposite, d, boxes.beyond_opposite + i);
        }
    }
}

/// Computes the boxes of triangles [first, last), and lists those that overlap the samples' bounds
/// in boxes.inside, and those with a vertex that is not projected in boxes.unprojected.
HWY_NOINLINE inline void find_boxes(
    const PencilMesh& mesh, std::size_t first, std::size_t last, GridBoxes& boxes)
{
    const Words d;
    boxes.first = first;
    gather_quantized_corners(mesh, first, last, boxes);
    boxes.inside_count = boxes.unprojected_count = 0;
    for (std::size_t i = 0; i < hwy::RoundUpTo(last - first, 8); i += hn::Lanes(d)) {
        const Word a = hn::Load(d, boxes.corner[0] + i), b = hn::Load(d, boxes.corner[1] + i),
                   c = hn::Load(d, boxes.corner[2] + i);
        const Word low = least16(least16(a, b), c), high = greatest16(greatest16(a, b), c);
        const auto given = hn::FirstN(d, std::max(i, last - first) - i);
        const auto unprojected = hn::And(given, any16(high, kQuantizedMax, 0xFFFF));
        if (!hn::AllFalse(d, unprojected)) [[unlikely]]
            append(i, unprojected, boxes.unprojected, boxes.unprojected_count);
        // The box is beside all samples on an axis, or behind all of them.
        const auto beside =
            hn::Or(any16(high, 0, kUpperHalf | 0xFFFF), any16(low, kQuantizedMax, kUpperHalf));
        const auto inside = hn::AndNot(hn::Or(beside, unprojected), given);
        const Word upper = hn::Set(d, kUpperHalf);
        hn::Store(hn::IfThenElse(inside, hn::And(low, upper), upper), d, boxes.low + i);
        hn::Store(hn::IfThenElseZero(inside, high), d, boxes.high + i);
        append(i, inside, boxes.inside, boxes.inside_count);
    }
}

/// Finds the strips of the triangles in boxes.inside, and removes the triangles that lie behind all
/// samples around them, as those on the far side of a body do. Bit k of the result is set if one of
/// the triangles 8 k to 8 k + 7 is left.
HWY_NOINLINE inline std::uint32_t remove_behind_samples(const SampleGrid& grid, GridBoxes& boxes)
{
    static_assert(GridBoxes::kTriangles == 32 * 8);
    std::size_t kept = 0;
    std::uint32_t groups = 0;
    for (std::size_t k = 0; k < boxes.inside_count; ++k) {
        const std::uint32_t i = boxes.inside[k];
        const StripRange strips = strips_of(grid, boxes.low[i], boxes.high[i]);
        const bool behind = is_behind(grid, strips, boxes.low[i], boxes.high[i]);
        boxes.inside[kept] = i;
        boxes.strips[kept] = strips;
        kept += !behind;
        groups |= std::uint32_t(!behind) << (i / 8);
    }
    boxes.inside_count = kept;
    return groups;
}

/// Finds strips and edges of the triangles in boxes.inside; removes some that shadow nothing.
HWY_INLINE void sort_boxes(const SampleGrid& grid, GridBoxes& boxes)
{
    std::uint32_t groups = 0;
    if (boxes.backoff.should_try()) {
        const std::size_t before = boxes.inside_count;
        groups = remove_behind_samples(grid, boxes);
        // Trying costs a third of what a triangle that is left costs.
        boxes.backoff.record(8 * (before - boxes.inside_count) >= before);
    } else {
        for (std::size_t k = 0; k < boxes.inside_count; ++k) {
            const std::uint32_t i = boxes.inside[k];
            boxes.strips[k] = strips_of(grid, boxes.low[i], boxes.high[i]);
            groups |= 1u << (i / 8);
        }
    }
    find_all_edges(grid, groups, boxes);
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
