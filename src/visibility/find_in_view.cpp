// find_in_view.cpp - the triangles of a range that may hit a sample: boxes a register at a time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visibility/find_in_view.cpp"
#include "base/simd.h"

#include "visibility/find_in_view.h"
#include "visibility/fragment_places-inl.h"
#include "visibility/tiny_triangles-inl.h"
#include "visibility/triangle_box.h"

#include <algorithm>
#include <bit>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

using Words = hn::CappedTag<std::int32_t, 16>;

/// Triangles whose boxes are found together.
constexpr std::size_t kGroup = 64;

/// Least and most of each triangle's corners, of a group of `count`.
struct GroupSamples {
    alignas(64) VertexSamples least[kGroup], most[kGroup];

    HWY_INLINE void find(const glm::vec4* HWY_RESTRICT corner, const glm::uvec3* HWY_RESTRICT index,
        std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i) {
            const float *a = &corner[index[i].x].w, *b = &corner[index[i].y].w,
                        *c = &corner[index[i].z].w;
#if HWY_TARGET == HWY_SCALAR
            const auto load = [](const float* v) { return std::bit_cast<VertexSamples>(*v); };
            const VertexSamples p = load(a), q = load(b), r = load(c);
            least[i] = {std::min({p.x, q.x, r.x}), std::min({p.y, q.y, r.y})};
            most[i] = {std::max({p.x, q.x, r.x}), std::max({p.y, q.y, r.y})};
#else
            const hn::FixedTag<std::int16_t, 2> d;
            const hn::FixedTag<float, 1> f;
            const auto load = [&](const float* v) { return hn::BitCast(d, hn::LoadU(f, v)); };
            const auto p = load(a), q = load(b), r = load(c);
            hn::StoreU(hn::Min(hn::Min(p, q), r), d, &least[i].x);
            hn::StoreU(hn::Max(hn::Max(p, q), r), d, &most[i].x);
#endif
        }
    }
};

/// One range of triangles on the way.
struct Search {
    ViewMemory& memory;
    TinyTriangles kind;
    std::uint32_t* counts;
    std::uint32_t* fragment_counts;
    InView* kept;
    FragmentTarget found;
    RangeCount count{};
    TinyList tiny, small, other; // boxes of at most 2x2 samples, 4x4, and more
    TinyCorners corners;

    /// Number i of the list becomes an entry of the tiles that its box meets.
    void keep(const TinyList& list, int i)
    {
        InView& box = kept[count.in_view];
        const std::uint32_t triangle = list.triangle[i];
        const glm::uvec3& index = memory.index[triangle];
        if (list.first[i] < 0) { // behind the eye
            if (!box_of(triangle, index, memory, box)) return;
        } else {
            const auto low = [](std::int32_t v) { return std::int16_t(v & 0xFFFF); };
            const auto high = [](std::int32_t v) { return std::int16_t(v >> 16); };
            const std::int32_t first = list.first[i], last = first + list.steps[i];
            const auto z = [&](std::uint32_t v) { return memory.corner[v].z; };
            box = {triangle, low(first), high(first), low(last), high(last),
                std::min({z(index.x), z(index.y), z(index.z)})};
        }
        for_tiles(box, memory, [&](int tx, int ty) { ++counts[ty * memory.tiles_x + tx]; });
        ++count.in_view;
    }

    HWY_INLINE void gather(const glm::vec4* HWY_RESTRICT corner,
        const glm::uvec3* HWY_RESTRICT index, const TinyList& list, int triangles)
    {
        for (int i = 0; i < triangles; ++i) {
            const glm::uvec3& at = index[list.triangle[i]];
            const glm::vec4 a = corner[at.x], b = corner[at.y], c = corner[at.z];
            std::memcpy(corners.corner[0][i], &a, sizeof(a));
            std::memcpy(corners.corner[1][i], &b, sizeof(b));
            std::memcpy(corners.corner[2][i], &c, sizeof(c));
        }
    }

    /// From samples to places, and counts them by tile.
    void place_fragments(std::uint32_t first)
    {
        const Marks d;
        const Places places(memory);
        for (std::uint32_t k = first; k < count.fragments; k += std::uint32_t(hn::Lanes(d))) {
            const auto place = places.of(hn::LoadU(d, found.place + k));
            hn::StoreU(place, d, found.place + k);
            const std::uint32_t left = std::min(count.fragments - k, std::uint32_t(hn::Lanes(d)));
            if (are_in_one_tile(place, left)) {
                fragment_counts[hn::GetLane(place) >> 16] += left;
            } else {
                for (std::uint32_t n = k; n < k + left; ++n)
                    ++fragment_counts[found.place[n] >> 16];
            }
        }
    }

    /// Tests the first triangles of the list.
    template <int kSide, bool kDepths, class D>
    void cover(D d, const TinyList& list, int triangles)
    {
        gather(memory.corner.data(), memory.index.data(), list, triangles);
        const std::uint32_t before = count.fragments;
        const int lanes = int(hn::Lanes(d));
        for (int i = 0; i < triangles; i += lanes)
            count.fragments =
                cover_tiny<kSide, kDepths>(d, list, corners, i, std::min(lanes, triangles - i),
                    float(memory.pencil.x0), float(memory.pencil.y0), found, count.fragments);
        place_fragments(before);
        count.tiny += std::uint32_t(triangles);
        for (int i = 0; i < triangles; ++i) {
            if (!corners.open[i]) [[likely]]
                continue;
            keep(list, i);
            --count.tiny;
        }
    }

    /// The first 64 of the list, or all.
    template <int kSide>
    void flush(TinyList& list, bool all)
    {
        const int triangles = all ? list.count : TinyList::kFull;
        const int most = kSide * kSide * triangles + int(hn::Lanes(Marks())); // in whole registers
        const bool room = count.fragments + std::uint32_t(most) <= memory.found_room;
        bool done = false;
        if constexpr (kSide > 0) {
            done = room;
            if (room && kind == TinyTriangles::depths)
                cover<kSide, true>(TinyDepths(), list, triangles);
            else if (room)
                cover<kSide, false>(TinyItems(), list, triangles);
        }
        for (int i = 0; i < triangles && !done; ++i) keep(list, i);
        list.count -= triangles;
        std::copy_n(list.triangle + triangles, list.count, list.triangle);
        std::copy_n(list.first + triangles, list.count, list.first);
        std::copy_n(list.steps + triangles, list.count, list.steps);
    }
};

/// Appends the lanes of the mask.
HWY_INLINE void append(hn::Vec<Words> triangle, hn::Vec<Words> first, hn::Vec<Words> steps,
    hn::Mask<Words> mask, TinyList& list)
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
        {memory.found.place.data() + found, memory.found.triangle.data() + found,
            memory.found.w.data() + found},
        {}, {}, {}, {}, {}};
    std::fill_n(search.counts, tiles, 0u);
    std::fill_n(search.fragment_counts, tiles, 0u);

    const bool any_tiny = kind != TinyTriangles::entries;
    // Boxes that touch the picture's border may be cut off there, their corners be anywhere.
    const auto last_x = hn::Set(d, memory.pencil.width - 1);
    const auto last_y = hn::Set(d, memory.pencil.height - 1);
    const auto zero = hn::Zero(d), one = hn::Set(d, 1), minus_one = hn::Set(d, -1);
    const auto low = [](auto v) { return hn::ShiftRight<16>(hn::ShiftLeft<16>(v)); };
    const auto high = [](auto v) { return hn::ShiftRight<16>(v); };
    const auto first_of = [](auto least) { return hn::ShiftRight<1>(least); };
    const auto last_of = [&](auto most) {
        return hn::Sub(hn::ShiftRight<1>(hn::Add(most, one)), one);
    };
    GroupSamples group;
    for (std::size_t t = first; t < last; t += kGroup) {
        const std::size_t count = std::min(kGroup, last - t);
        group.find(memory.corner.data(), &memory.index[t], count);
        for (std::size_t i = 0; i < count; i += lanes) {
            const auto load = [&](const VertexSamples* from) {
                return hn::Load(d, reinterpret_cast<const std::int32_t*>(from + i));
            };
            const auto least = load(group.least), most = load(group.most);
            const auto x0 = first_of(low(least)), y0 = first_of(high(least));
            const auto x1 = last_of(low(most)), y1 = last_of(high(most));
            const auto steps_x = hn::Sub(x1, x0), steps_y = hn::Sub(y1, y0);
            const auto behind = hn::Lt(x0, zero);
            const auto holds = hn::Gt(hn::Min(steps_x, steps_y), minus_one);
            const auto seen = hn::And(hn::FirstN(d, count - i), hn::Or(behind, holds));
            if (hn::AllFalse(d, seen)) continue;
            const auto inner = hn::And(
                hn::Gt(hn::Min(x0, y0), zero), hn::And(hn::Lt(x1, last_x), hn::Lt(y1, last_y)));
            const auto side = hn::Max(steps_x, steps_y);
            const auto at_most = [&](int n) {
                return hn::And(hn::And(seen, inner), hn::Lt(side, hn::Set(d, any_tiny ? n : 0)));
            };
            const auto is_tiny = at_most(2), is_small = hn::AndNot(is_tiny, at_most(4));
            const auto triangle =
                hn::Add(hn::Set(d, std::int32_t(t + i)), hn::Iota(d, std::int32_t(0)));
            const auto begin = hn::Or(x0, hn::ShiftLeft<16>(y0)); // < 0: behind
            const auto steps = hn::Or(steps_x, hn::ShiftLeft<16>(steps_y));
            append(triangle, begin, steps, is_tiny, search.tiny);
            if (hn::AllTrue(d, hn::Or(is_tiny, hn::Not(seen)))) continue;
            append(triangle, begin, steps, is_small, search.small);
            append(
                triangle, begin, steps, hn::AndNot(hn::Or(is_tiny, is_small), seen), search.other);
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
HWY_EXPORT(scatter_range);

void find_in_view(std::size_t range, TinyTriangles tiny, ViewMemory& memory)
{
    HWY_DYNAMIC_DISPATCH(find_range)(range, tiny, memory);
}

void scatter_fragments(std::size_t range, ViewMemory& memory)
{
    HWY_DYNAMIC_DISPATCH(scatter_range)(range, memory);
}

} // namespace firsthit
#endif
