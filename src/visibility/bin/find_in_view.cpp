// find_in_view.cpp - finds the triangles of a range that may hit a sample, a register at a time.
//
// Triangles in view are collected in three lists by the size of their boxes. A list that is full is
// emptied: tiny triangles become fragments, the others entries.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visibility/bin/find_in_view.cpp"
#include "base/simd.h"

#include "visibility/bin/corner_registers-inl.h"
#include "visibility/bin/find_in_view.h"
#include "visibility/bin/flat_triangles-inl.h"
#include "visibility/bin/fragment_places-inl.h"
#include "visibility/bin/tiny_triangles-inl.h"
#include "visibility/bin/triangle_box.h"

#include <algorithm>
#include <bit>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

using Words = TinyList::Words;
using Corner = CornerRegisters<TinyList::D>;

/// The search through one range of triangles.
struct Search {
    const TileLayout& layout;
    const EyeMesh& mesh;
    TinyTriangles kind;
    std::uint32_t* counts;          // (tiles) entries
    std::uint32_t* fragment_counts; // (tiles)
    InView* kept;                   // triangles that get entries
    FragmentTarget found;
    std::uint32_t found_room; // fragments for which `found` has room
    RangeCount count{};
    TinyList tiny, small, other; // boxes of at most 2x2 samples, of at most 4x4, and larger ones

    /// Triangle number i of the list gets an entry in the tiles that its box meets.
    void keep(const TinyList& list, int i)
    {
        InView& box = kept[count.in_view];
        const std::uint32_t triangle = list.triangle[i];
        if (list.first[i] < 0) { // a corner is behind the eye
            if (!box_of(triangle, mesh, layout.pencil, box)) return;
        } else {
            const auto low = [](std::int32_t v) { return std::int16_t(v & 0xFFFF); };
            const auto high = [](std::int32_t v) { return std::int16_t(v >> 16); };
            const std::int32_t first = list.first[i], last = first + list.steps[i];
            box = {triangle, low(first), high(first), low(last), high(last),
                nearest_z(mesh, mesh.index[triangle])};
        }
        for_tiles(box, layout, [&](int tx, int ty) { ++counts[ty * layout.tiles_x + tx]; });
        ++count.in_view;
    }

    /// Replaces the samples of the fragments from number `first` on by their places
    /// (Fragment::sample), and counts the fragments by tile.
    void place_fragments(std::uint32_t first)
    {
        const Marks d;
        const Places places(layout);
        for (std::uint32_t k = first; k < count.fragments; k += std::uint32_t(hn::Lanes(d))) {
            const auto place = places.of(hn::LoadU(d, found.place + k));
            hn::StoreU(place, d, found.place + k);
            const std::uint32_t left = std::min(count.fragments - k, std::uint32_t(hn::Lanes(d)));
            for_tiles_of(place, left, [&](std::uint32_t tile, std::uint64_t in_it) {
                fragment_counts[tile] += std::uint32_t(std::popcount(in_it));
            });
        }
    }

    /// Makes fragments of the first triangles of the list, and entries of those whose fragments are
    /// not certain.
    template <int kSide, CornerSpace kSpace>
    void cover(TinyList& list, int triangles)
    {
        constexpr bool kFlat = kSpace == CornerSpace::flat;
        const std::conditional_t<kFlat, TinyList::D, TinyItems> d;
        const std::uint32_t before = count.fragments;
        const FragmentTarget to = found;
        std::uint32_t fragments = before;
        const int lanes = int(hn::Lanes(d));
        const LatticeTile rays = layout.pencil.tile(0, 0);
        for (int i = 0; i < triangles; i += lanes) {
            const ListRegister lane{list, i, std::min(lanes, triangles - i)};
            if constexpr (kFlat)
                fragments = cover_flat<kSide>(d, lane, rays, to, fragments);
            else
                fragments = cover_tiny<kSide>(d, lane, rays, to, fragments);
        }
        count.fragments = fragments;
        place_fragments(before);
        count.tiny += std::uint32_t(triangles);
        const Marks marks;
        for (int begin = 0; begin < triangles; begin += int(hn::Lanes(marks))) {
            const auto open = hn::Load(marks, list.open + begin);
            if (hn::AllTrue(marks, hn::Eq(open, hn::Zero(marks)))) [[likely]]
                continue;
            const int end = std::min(triangles, begin + int(hn::Lanes(marks)));
            for (int i = begin; i < end; ++i) {
                if (!list.open[i]) continue;
                keep(list, i);
                --count.tiny;
            }
        }
    }

    /// Takes the first kFull triangles out of the list, or all of them.
    ///
    /// kSide  samples on a side of the boxes, at most; 0 for boxes that are too large for fragments
    template <int kSide>
    void flush(TinyList& list, bool all)
    {
        const int triangles = all ? list.count : TinyList::kFull;
        // Fragments are written a whole register at a time.
        const int most = kSide * kSide * triangles + int(hn::Lanes(Marks()));
        bool done = false;
        if constexpr (kSide > 0) {
            done = count.fragments + std::uint32_t(most) <= found_room;
            if (done && kind == TinyTriangles::depths)
                cover<kSide, CornerSpace::flat>(list, triangles);
            else if (done)
                cover<kSide, CornerSpace::eye>(list, triangles);
        }
        for (int i = 0; i < triangles && !done; ++i) keep(list, i);
        list.template drop<(kSide > 0)>(triangles);
    }
};

/// The least and the greatest VertexSamples of each triangle's corners.
struct Extremes {
    hn::Vec<Words> least, most;

    HWY_INLINE explicit Extremes(const Corner (&corner)[3])
    {
        const Words d;
        const auto a = corner[0].samples(), b = corner[1].samples(), c = corner[2].samples();
#if HWY_TARGET == HWY_SCALAR
        const auto of = [](auto v) { return std::bit_cast<VertexSamples>(hn::GetLane(v)); };
        const VertexSamples p = of(a), q = of(b), r = of(c);
        const auto both = [&](int x, int y) { return hn::Set(d, (x & 0xFFFF) | y * 0x10000); };
        least = both(std::min({p.x, q.x, r.x}), std::min({p.y, q.y, r.y}));
        most = both(std::max({p.x, q.x, r.x}), std::max({p.y, q.y, r.y}));
#else
        const hn::Repartition<std::int16_t, Words> halves;
        const auto of = [&](auto v) { return hn::BitCast(halves, v); };
        least = hn::BitCast(d, hn::Min(hn::Min(of(a), of(b)), of(c)));
        most = hn::BitCast(d, hn::Max(hn::Max(of(a), of(b)), of(c)));
#endif
    }
};

/// A register of triangles and their boxes.
struct Boxes {
    hn::Vec<Words> triangle, first, steps; // see TinyList
};

/// Appends the triangles in the lanes of the mask to the list.
HWY_INLINE void append(const Boxes& boxes, hn::Mask<Words> mask, TinyList& list)
{
    const Words d;
    const hn::RebindToUnsigned<Words> du;
    const int at = list.count;
    hn::StoreU(hn::BitCast(du, hn::Compress(boxes.triangle, mask)), du, list.triangle + at);
    hn::StoreU(hn::Compress(boxes.first, mask), d, list.first + at);
    hn::StoreU(hn::Compress(boxes.steps, mask), d, list.steps + at);
    list.count = at + int(hn::CountTrue(d, mask));
}

/// Appends the triangles and their corners.
HWY_INLINE void append(
    const Boxes& boxes, const Corner (&corner)[3], hn::Mask<Words> mask, TinyList& list)
{
    const TinyList::D d;
    const auto lanes = hn::RebindMask(d, mask);
    const int at = list.count;
    for (int k = 0; k < 3; ++k) {
        const auto store = [&](auto v, int axis) {
            hn::StoreU(hn::Compress(v, lanes), d, list.corner[3 * k + axis] + at);
        };
        store(corner[k].x(), 0);
        store(corner[k].y(), 1);
        store(corner[k].z(), 2);
    }
    append(boxes, mask, list);
}

/// The lanes of triangles that are cut-outs, of the register that starts at triangle t.
HWY_INLINE hn::Mask<Words> cutout_lanes(const Cutouts& cutouts, std::size_t t, std::size_t last)
{
    const Words d;
    alignas(64) std::int32_t is_cutout[16] = {};
    for (std::size_t k = 0; k < hn::Lanes(d) && t + k < last; ++k)
        is_cutout[k] = cutouts.has(std::uint32_t(t + k));
    return hn::Ne(hn::Load(d, is_cutout), hn::Zero(d));
}

/// The lanes of triangles whose boxes, of the samples from (x0, y0) to (x1, y1), meet a wanted block.
/// x0 is negative in lanes without a box, which are kept.
HWY_INLINE hn::Mask<Words> wanted_lanes(const BlockBits& wanted, hn::Vec<Words> x0,
    hn::Vec<Words> y0, hn::Vec<Words> x1, hn::Vec<Words> y1)
{
    const Words d;
    alignas(64) std::int32_t box[4][16], keep[16] = {};
    hn::Store(x0, d, box[0]);
    hn::Store(y0, d, box[1]);
    hn::Store(x1, d, box[2]);
    hn::Store(y1, d, box[3]);
    for (std::size_t k = 0; k < hn::Lanes(d); ++k)
        keep[k] = box[0][k] < 0 || wanted.any({box[0][k] / kBlock, box[1][k] / kBlock,
                                       box[2][k] / kBlock, box[3][k] / kBlock});
    return hn::Ne(hn::Load(d, keep), hn::Zero(d));
}

/// The lanes of triangles that have no part in front of the eye. careful_box would find no box for
/// them either, but one by one. A flat corner in front of the eye has 1/z > 0 in place of z. A
/// triangle with a corner that is NaN is never seen.
HWY_INLINE hn::Mask<Words> all_behind(const Corner (&corner)[3])
{
    const TinyList::D d;
    const auto nearest = hn::Max(corner[0].z(), hn::Max(corner[1].z(), corner[2].z()));
    return hn::RebindMask(Words(), hn::Le(nearest, hn::Zero(d)));
}

void find_range(std::size_t range, const TileLayout& layout, const EyeMesh& mesh,
    TinyTriangles kind, Bins& bins)
{
    const Words d;
    const std::size_t lanes = hn::Lanes(d);
    const std::size_t first = range * kTriangleRange,
                      last = std::min(mesh.index.size(), first + kTriangleRange);
    const std::size_t tiles = std::size_t(layout.tiles()), found = range * bins.found_room;
    Search search{layout, mesh, kind, &bins.cursor[range * tiles],
        &bins.fragment_cursor[range * tiles], &bins.in_view[first],
        {bins.found.place.data() + found, bins.found.triangle.data() + found,
            bins.found.w.data() + found},
        bins.found_room, {}, {}, {}, {}};
    std::fill_n(search.counts, tiles, 0u);
    std::fill_n(search.fragment_counts, tiles, 0u);

    const bool any_cutouts = mesh.cutouts.any();
    const bool any_tiny = kind != TinyTriangles::entries;
    // A box that touches the picture's border may be cut off there, and then the corners of its
    // triangle may be far away.
    const auto last_x = hn::Set(d, layout.pencil.width - 1);
    const auto last_y = hn::Set(d, layout.pencil.height - 1);
    const auto zero = hn::Zero(d), one = hn::Set(d, 1), minus_one = hn::Set(d, -1);
    const auto low = [](auto v) { return hn::ShiftRight<16>(hn::ShiftLeft<16>(v)); };
    const auto high = [](auto v) { return hn::ShiftRight<16>(v); };
    const auto first_of = [](auto least) { return hn::ShiftRight<1>(least); };
    const auto last_of = [&](auto most) {
        return hn::Sub(hn::ShiftRight<1>(hn::Add(most, one)), one);
    };
    alignas(64) std::uint32_t rest[3 * 16];
    for (std::size_t t = first; t < last; t += lanes) {
        const std::uint32_t* index = &mesh.index[t].x;
        if (t + lanes > last) {
            // The last register is filled up with its last triangle.
            for (std::size_t k = 0; k < lanes; ++k)
                std::copy_n(&mesh.index[std::min(t + k, last - 1)].x, 3, rest + 3 * k);
            index = rest;
        }
        const TinyList::D f;
        const glm::vec4* corners = mesh.corner.data();
        const Corner corner[3] = {
            {f, corners, index}, {f, corners, index + 1}, {f, corners, index + 2}};
        const Extremes samples(corner);
        const auto x0 = first_of(low(samples.least)), y0 = first_of(high(samples.least));
        const auto x1 = last_of(low(samples.most)), y1 = last_of(high(samples.most));
        const auto steps_x = hn::Sub(x1, x0), steps_y = hn::Sub(y1, y0);
        const auto behind = hn::Lt(x0, zero);
        const auto holds = hn::Gt(hn::Min(steps_x, steps_y), minus_one);
        auto seen = hn::And(hn::FirstN(d, last - t), hn::Or(behind, holds));
        if (hn::AllFalse(d, seen)) continue;
        if (!hn::AllFalse(d, behind)) [[unlikely]] {
            seen = hn::AndNot(all_behind(corner), seen);
            if (hn::AllFalse(d, seen)) continue;
        }
        if (layout.wanted) {
            seen = hn::And(seen, wanted_lanes(*layout.wanted, x0, y0, x1, y1));
            if (hn::AllFalse(d, seen)) continue;
        }
        auto inner =
            hn::And(hn::Gt(hn::Min(x0, y0), zero), hn::And(hn::Lt(x1, last_x), hn::Lt(y1, last_y)));
        // Cut-outs have no fragments.
        if (any_cutouts) [[unlikely]]
            inner = hn::AndNot(cutout_lanes(mesh.cutouts, t, last), inner);
        const auto side = hn::Max(steps_x, steps_y);
        const auto at_most = [&](int n) {
            return hn::And(hn::And(seen, inner), hn::Lt(side, hn::Set(d, any_tiny ? n : 0)));
        };
        const auto is_tiny = at_most(2), is_small = hn::AndNot(is_tiny, at_most(4));
        const Boxes boxes{hn::Add(hn::Set(d, std::int32_t(t)), hn::Iota(d, std::int32_t(0))),
            hn::Or(x0, hn::ShiftLeft<16>(y0)), hn::Or(steps_x, hn::ShiftLeft<16>(steps_y))};
        append(boxes, corner, is_tiny, search.tiny);
        if (search.tiny.count >= TinyList::kFull) search.flush<2>(search.tiny, false);
        if (hn::AllTrue(d, hn::Or(is_tiny, hn::Not(seen)))) continue;
        append(boxes, corner, is_small, search.small);
        append(boxes, hn::AndNot(hn::Or(is_tiny, is_small), seen), search.other);
        if (search.small.count >= TinyList::kFull) search.flush<4>(search.small, false);
        if (search.other.count >= TinyList::kFull) search.flush<0>(search.other, false);
    }
    search.flush<2>(search.tiny, true);
    search.flush<4>(search.small, true);
    search.flush<0>(search.other, true);
    bins.range_count[range] = search.count;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(find_range);
HWY_EXPORT(scatter_range);

void find_in_view(std::size_t range, const TileLayout& layout, const EyeMesh& mesh,
    TinyTriangles tiny, Bins& bins)
{
    HWY_DYNAMIC_DISPATCH(find_range)(range, layout, mesh, tiny, bins);
}

void scatter_fragments(std::size_t range, std::size_t tiles, CornerSpace space, Bins& bins)
{
    HWY_DYNAMIC_DISPATCH(scatter_range)(range, tiles, space, bins);
}

} // namespace firsthit
#endif
