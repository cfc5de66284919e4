// find_in_view.cpp - the triangles of a range that may hit a sample: boxes a register at a time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visibility/find_in_view.cpp"
#include "base/simd.h"

#include "visibility/find_in_view.h"
#include "visibility/tiny_triangles-inl.h"
#include "visibility/triangle_box.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

using Words = hn::CappedTag<std::int32_t, 16>;

/// Triangles whose boxes are found together.
constexpr std::size_t kGroup = 64;

/// Boxes of `count` triangles from their corners' boxes.
HWY_INLINE void find_boxes(
    const VertexBox* box, const glm::uvec3* index, std::size_t count, VertexBox* found)
{
    for (std::size_t i = 0; i < count; ++i) {
        const VertexBox &a = box[index[i].x], &b = box[index[i].y], &c = box[index[i].z];
#if HWY_TARGET == HWY_SCALAR
        found[i] = {std::min({a.first_x, b.first_x, c.first_x}),
            std::min({a.first_y, b.first_y, c.first_y}),
            std::min({a.minus_last_x, b.minus_last_x, c.minus_last_x}),
            std::min({a.minus_last_y, b.minus_last_y, c.minus_last_y})};
#else
        const hn::FixedTag<std::int16_t, 4> d;
        const auto load = [&](const VertexBox& v) { return hn::LoadU(d, &v.first_x); };
        hn::StoreU(hn::Min(hn::Min(load(a), load(b)), load(c)), d, &found[i].first_x);
#endif
    }
}

/// One range of triangles on the way.
struct Search {
    ViewMemory& memory;
    TinyTriangles kind;
    std::uint32_t* counts;
    std::uint32_t* fragment_counts;
    InView* kept;
    FoundFragments found;
    RangeCount count{};
    TinyList tiny, small, other; // boxes of at most 2x2 samples, 4x4, and more
    TinyCorners corners;

    void keep(std::uint32_t triangle)
    {
        InView& box = kept[count.in_view];
        if (!box_of(triangle, memory.index[triangle], memory, box)) return;
        for_tiles(box, memory, [&](int tx, int ty) { ++counts[ty * memory.tiles_x + tx]; });
        ++count.in_view;
    }

    /// From samples to places, and counts them by tile.
    void place_fragments(std::uint32_t first)
    {
        for (std::uint32_t k = first; k < count.fragments; ++k) {
            const std::uint32_t at = found.place[k];
            const std::uint32_t place =
                memory.column_place[at & 0xFFFF] + memory.row_place[at >> 16];
            found.place[k] = place;
            ++fragment_counts[place >> 16];
        }
    }

    /// Tests the first triangles of the list.
    template <int kSide, bool kDepths, class D>
    void cover(D d, const TinyList& list, int triangles)
    {
        for (int i = 0; i < triangles; ++i) {
            const glm::uvec3& index = memory.index[list.triangle[i]];
            for (int k = 0; k < 3; ++k)
                std::memcpy(corners.corner[k][i], &memory.corner[index[k]], sizeof(glm::vec4));
        }
        const std::uint32_t before = count.fragments;
        const int lanes = int(hn::Lanes(d));
        for (int i = 0; i < triangles; i += lanes)
            count.fragments = cover_tiny<kSide, kDepths>(d, list, corners, i,
                std::min(lanes, triangles - i), float(memory.pencil.x0), float(memory.pencil.y0),
                found, count.fragments);
        place_fragments(before);
        count.tiny += std::uint32_t(triangles);
        for (int i = 0; i < triangles; ++i) {
            if (!corners.open[i]) [[likely]]
                continue;
            keep(list.triangle[i]);
            --count.tiny;
        }
    }

    /// The first 64 of the list, or all.
    template <int kSide>
    void flush(TinyList& list, bool all)
    {
        const int triangles = all ? list.count : TinyList::kFull;
        const bool room = count.fragments + std::uint32_t(kSide * kSide * triangles) +
                              std::uint32_t(hn::Lanes(TinyItems())) <=
                          memory.found_room;
        bool done = false;
        if constexpr (kSide > 0) {
            done = room;
            if (room && kind == TinyTriangles::depths)
                cover<kSide, true>(TinyDepths(), list, triangles);
            else if (room)
                cover<kSide, false>(TinyItems(), list, triangles);
        }
        for (int i = 0; i < triangles && !done; ++i) keep(list.triangle[i]);
        list.count -= triangles;
        std::copy_n(list.triangle + triangles, list.count, list.triangle);
        std::copy_n(list.first + triangles, list.count, list.first);
        std::copy_n(list.steps + triangles, list.count, list.steps);
    }
};

/// Appends the lanes of the mask, and asks for their corners' memory.
HWY_INLINE void append(hn::Vec<Words> triangle, hn::Vec<Words> first,
    hn::Vec<Words> steps, hn::Mask<Words> mask, TinyList& list)
{
    const Words d;
    const hn::RebindToUnsigned<Words> du;
    hn::StoreU(hn::BitCast(du, hn::Compress(triangle, mask)), du, list.triangle + list.count);
    hn::StoreU(hn::Compress(first, mask), d, list.first + list.count);
    hn::StoreU(hn::Compress(steps, mask), d, list.steps + list.count);
    list.count += int(hn::CountTrue(d, mask));
}

void find_range(std::size_t range, TinyTriangles kind, ViewMemory& memory)
{
    const Words d;
    const std::size_t lanes = hn::Lanes(d);
    const std::size_t first = range * kTriangleRange,
                      last = std::min(memory.index.size(), first + kTriangleRange);
    const std::size_t tiles = std::size_t(memory.tiles()), found = range * memory.found_room;
    Search search{memory, kind, &memory.cursor[range * tiles],
        &memory.fragment_cursor[range * tiles], &memory.in_view[first],
        {memory.found_place.data() + found, memory.found_triangle.data() + found,
            memory.found_w.data() + found},
        {}, {}, {}, {}, {}};
    std::fill_n(search.counts, tiles, 0u);
    std::fill_n(search.fragment_counts, tiles, 0u);

    const bool any_tiny = kind != TinyTriangles::entries;
    // Boxes that touch the picture's border may be cut off there, their corners be anywhere.
    const auto last_x = hn::Set(d, 1 - memory.pencil.width);
    const auto last_y = hn::Set(d, 1 - memory.pencil.height);
    const auto zero = hn::Zero(d), minus_one = hn::Set(d, -1);
    const auto low = [](auto v) { return hn::ShiftRight<16>(hn::ShiftLeft<16>(v)); };
    const auto high = [](auto v) { return hn::ShiftRight<16>(v); };
    alignas(64) VertexBox boxes[kGroup];
    for (std::size_t t = first; t < last; t += kGroup) {
        const std::size_t count = std::min(kGroup, last - t);
        find_boxes(memory.box.data(), &memory.index[t], count, boxes);
        for (std::size_t i = 0; i < count; i += lanes) {
            auto begin = zero, end = zero; // first, minus last
            hn::LoadInterleaved2(d, reinterpret_cast<const std::int32_t*>(&boxes[i]), begin, end);
            const auto x = low(begin), y = high(begin), minus_x1 = low(end), minus_y1 = high(end);
            const auto steps_x = hn::Neg(hn::Add(x, minus_x1));
            const auto steps_y = hn::Neg(hn::Add(y, minus_y1));
            const auto behind = hn::Eq(x, minus_one);
            const auto holds = hn::Gt(hn::Min(steps_x, steps_y), minus_one);
            const auto seen = hn::And(hn::FirstN(d, count - i), hn::Or(behind, holds));
            if (hn::AllFalse(d, seen)) continue;
            const auto inner = hn::And(hn::Gt(hn::Min(x, y), zero),
                hn::And(hn::Gt(minus_x1, last_x), hn::Gt(minus_y1, last_y)));
            const auto most = hn::Max(steps_x, steps_y);
            const auto at_most = [&](int n) {
                return hn::And(hn::And(seen, inner), hn::Lt(most, hn::Set(d, any_tiny ? n : 0)));
            };
            const auto is_tiny = at_most(2), is_small = hn::AndNot(is_tiny, at_most(4));
            const auto triangle =
                hn::Add(hn::Set(d, std::int32_t(t + i)), hn::Iota(d, std::int32_t(0)));
            const auto steps = hn::Or(steps_x, hn::ShiftLeft<16>(steps_y));
            append(triangle, begin, steps, is_tiny, search.tiny);
            append(triangle, begin, steps, is_small, search.small);
            append(triangle, begin, steps,
                hn::AndNot(hn::Or(is_tiny, is_small), seen), search.other);
        }
        if (search.tiny.count >= TinyList::kFull) search.flush<2>(search.tiny, false);
        if (search.small.count >= TinyList::kFull) search.flush<4>(search.small, false);
        if (search.other.count >= TinyList::kFull) search.flush<0>(search.other, false);
    }
    search.flush<2>(search.tiny, true);
    search.flush<4>(search.small, true);
    search.flush<0>(search.other, true);
    memory.range_count[range] = search.count;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(find_range);

void find_in_view(std::size_t range, TinyTriangles tiny, ViewMemory& memory)
{
    HWY_DYNAMIC_DISPATCH(find_range)(range, tiny, memory);
}

} // namespace firsthit
#endif
