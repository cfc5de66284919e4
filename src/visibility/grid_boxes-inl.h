// grid_boxes-inl.h - triangles onto a grid of samples, several at a time: boxes of places, and for
// those that lie in one cell, as most small ones do, where that is and which of its parts they meet.
#if defined(FIRSTHIT_VISIBILITY_GRID_BOXES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTHIT_VISIBILITY_GRID_BOXES_INL_H_
#undef FIRSTHIT_VISIBILITY_GRID_BOXES_INL_H_
#else
#define FIRSTHIT_VISIBILITY_GRID_BOXES_INL_H_
#endif

#include <hwy/highway.h>

#include "visibility/sample_grid.h"
#include "visibility/sample_registers-inl.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The places of a box, ends included.
struct alignas(8) GridRect {
    std::uint16_t x0, y0, x1, y1;
};

/// Some triangles, and what is known of them.
struct GridBoxes {
    static constexpr std::size_t kTriangles = 256;
    static constexpr std::size_t kRoom = kTriangles + 16;

    std::size_t first = 0; // number of the first one
    alignas(64) GridPlace corner[3][kRoom];
    alignas(64) GridRect rect[kRoom];
    alignas(64) std::uint64_t nearest_w[kRoom]; // place
    alignas(64) std::uint64_t cell[kRoom];      // of those in one cell
    alignas(64) std::uint64_t parts[kRoom];     // and of that cell

    // Which of them
    std::size_t single_count = 0, other_count = 0, unseen_count = 0;
    std::uint32_t single[kRoom]; // lie in one cell
    std::uint32_t other[kRoom];  // do not
    std::uint32_t unseen[kRoom]; // have a corner that is not seen
};

using Words = hn::CappedTag<std::uint64_t, 8>;
using Word = hn::Vec<Words>;

/// The least of each 16 bits.
HWY_INLINE Word least16(Word a, Word b)
{
#if HWY_TARGET == HWY_SCALAR
    std::uint64_t least = 0;
    for (int k = 0; k < 64; k += 16)
        least |= std::min(a.raw >> k & 0xFFFF, b.raw >> k & 0xFFFF) << k;
    return hn::Set(Words(), least);
#else
    const hn::Repartition<std::uint16_t, Words> d;
    return hn::BitCast(Words(), hn::Min(hn::BitCast(d, a), hn::BitCast(d, b)));
#endif
}

/// The greatest of each 16 bits.
HWY_INLINE Word greatest16(Word a, Word b)
{
    const Word all = hn::Set(Words(), ~std::uint64_t(0));
    return hn::Xor(least16(hn::Xor(a, all), hn::Xor(b, all)), all);
}

/// The words some of whose 16 bits are those of `what`, where `where` has bits.
HWY_INLINE hn::Mask<Words> any16(Word v, std::uint16_t what, std::uint64_t where)
{
    const Words d;
#if HWY_TARGET == HWY_SCALAR
    bool any = false;
    for (int k = 0; k < 64; k += 16)
        any = any || ((where >> k & 1) && (v.raw >> k & 0xFFFF) == what);
    return hn::Eq(hn::Set(d, std::uint64_t(any)), hn::Set(d, 1));
#else
    const hn::Repartition<std::uint16_t, Words> n;
    const auto equal =
        hn::BitCast(d, hn::VecFromMask(n, hn::Eq(hn::BitCast(n, v), hn::Set(n, what))));
    return hn::Ne(hn::And(equal, hn::Set(d, where)), hn::Zero(d));
#endif
}

/// The lowest byte in all eight.
HWY_INLINE Word in_all_bytes(Word v)
{
    const Words d;
#if HWY_TARGET == HWY_SCALAR
    return hn::Set(d, v.raw * 0x0101010101010101u);
#else
    const hn::Repartition<std::uint8_t, Words> n;
    alignas(64) static constexpr std::uint8_t kFirst[64] = {0, 0, 0, 0, 0, 0, 0, 0, 8, 8, 8, 8, 8,
        8, 8, 8, 0, 0, 0, 0, 0, 0, 0, 0, 8, 8, 8, 8, 8, 8, 8, 8, 0, 0, 0, 0, 0, 0, 0, 0, 8, 8, 8, 8,
        8, 8, 8, 8, 0, 0, 0, 0, 0, 0, 0, 0, 8, 8, 8, 8, 8, 8, 8, 8};
    return hn::BitCast(d, hn::TableLookupBytes(hn::BitCast(n, v), hn::Load(n, kFirst)));
#endif
}

/// Appends the numbers from `first` on of the chosen lanes. What is written after them is nothing.
HWY_INLINE void append(
    std::size_t first, hn::Mask<Words> chosen, std::uint32_t* to, std::size_t& count)
{
    const hn::Rebind<std::uint32_t, Words> d;
    const std::uint8_t byte[8] = {std::uint8_t(bits(Words(), chosen))};
    const auto lanes = hn::LoadMaskBits(d, byte);
    hn::StoreU(hn::Compress(hn::Iota(d, std::uint32_t(first)), lanes), d, to + count);
    count += hn::CountTrue(Words(), chosen);
}

HWY_INLINE void store_words(Word v, void* to)
{
    hn::Store(v, Words(), static_cast<std::uint64_t*>(to));
}

/// The corners of triangles [first, last), in turn.
HWY_INLINE void gather_places(
    const LightMesh& mesh, std::size_t first, std::size_t last, GridBoxes& boxes)
{
    const glm::uvec3* const index = mesh.index.data() + first;
    const GridPlace* const place = mesh.place.data();
    for (std::size_t i = 0; i < last - first; ++i)
        for (int k = 0; k < 3; ++k)
            std::memcpy(&boxes.corner[k][i], &place[index[i][k]], sizeof(GridPlace));
}

/// Sorts triangles [first, last): what reaches no sample is left out.
HWY_NOINLINE void sort_boxes(const LightMesh& mesh, const SampleGrid& grid, std::size_t first,
    std::size_t last, GridBoxes& boxes)
{
    const Words d;
    const auto set = [&](std::uint64_t v) { return hn::Set(d, v); };
    boxes.first = first;
    gather_places(mesh, first, last, boxes);
    boxes.single_count = boxes.other_count = boxes.unseen_count = 0;
    for (std::size_t i = 0; i < last - first; i += hn::Lanes(d)) {
        const auto corner = [&](int k) {
            return hn::Load(d, reinterpret_cast<const std::uint64_t*>(&boxes.corner[k][i]));
        };
        const Word a = corner(0), b = corner(1), c = corner(2);
        const Word low = least16(least16(a, b), c), high = greatest16(greatest16(a, b), c);
        const auto given = hn::FirstN(d, last - first - i);
        const auto unseen = hn::And(given, any16(high, kLastPlace, 0xFFFF00000000));
        if (!hn::AllFalse(d, unseen)) [[unlikely]]
            append(i, unseen, boxes.unseen, boxes.unseen_count);
        // Above or below all samples on an axis, or farther than all.
        const auto beside =
            hn::Or(any16(high, 0, 0xFFFFFFFFFFFF), any16(low, kLastPlace, 0xFFFFFFFF));
        const auto inside = hn::AndNot(hn::Or(beside, unseen), given);
        if (hn::AllFalse(d, inside)) continue;

        const Word low16 = set(0xFFFF);
        const Word x0 = hn::And(low, low16), y0 = hn::And(hn::ShiftRight<16>(low), low16),
                   x1 = hn::And(high, low16), y1 = hn::And(hn::ShiftRight<16>(high), low16),
                   nearest_w = hn::And(hn::ShiftRight<32>(high), low16);
        const Word coarse =
            hn::GatherIndex(d, reinterpret_cast<const std::uint64_t*>(grid.coarse.data()),
                hn::BitCast(hn::RebindToSigned<Words>(),
                    hn::Or(hn::ShiftLeft<kCoarseBits>(hn::ShiftRight<kFineBits>(y0)),
                        hn::ShiftRight<kFineBits>(x0))));
        const Word level = hn::And(hn::ShiftRight<32>(coarse), low16);
        const Word shift = hn::Sub(set(kFineBits), level);
        const Word column = hn::Shr(x0, shift), row = hn::Shr(y0, shift);
        const auto single = hn::And(
            hn::And(hn::Eq(column, hn::Shr(x1, shift)), hn::Eq(row, hn::Shr(y1, shift))), inside);
        const hn::RebindToSigned<Words> i64;
        const auto behind = hn::RebindMask(
            d, hn::Lt(hn::BitCast(i64, nearest_w), hn::BitCast(i64, hn::ShiftRight<48>(coarse))));

        store_words(nearest_w, &boxes.nearest_w[i]);
        store_words(hn::Or(hn::And(low, set(0xFFFFFFFF)), hn::ShiftLeft<32>(high)), &boxes.rect[i]);
        append(i, hn::AndNot(single, inside), boxes.other, boxes.other_count);
        const Word part = hn::Sub(set(kMostLevels), level), seven = set(7);
        const auto inner = [&](Word v) { return hn::And(hn::Shr(v, part), seven); };
        const Word columns =
            hn::And(hn::Shr(set(0xFF), hn::Sub(seven, inner(x1))), hn::Shl(set(0xFF), inner(x0)));
        const Word rows =
            hn::And(hn::Shr(set(~std::uint64_t(0)), hn::ShiftLeft<3>(hn::Sub(seven, inner(y1)))),
                hn::Shl(set(~std::uint64_t(0)), hn::ShiftLeft<3>(inner(y0))));
        const Word in_coarse = hn::Sub(hn::Shl(set(1), level), set(1));
        const Word cell = hn::Add(hn::And(coarse, set(0xFFFFFFFF)),
            hn::Add(hn::Shl(hn::And(row, in_coarse), level), hn::And(column, in_coarse)));
        store_words(cell, &boxes.cell[i]);
        store_words(hn::And(in_all_bytes(columns), rows), &boxes.parts[i]);
        append(i, hn::AndNot(behind, single), boxes.single, boxes.single_count);
    }
}

} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#endif // include guard for each target
