// fill_holes.cpp - fills pixels that have no colour with the mean of the colours around them.
//
// Most holes have a pixel with a colour beside them. So rows are done a register at a time with
// windows of 3 x 3 and 5 x 5, and the holes that remain one by one. Registers also load the colours
// of holes, and drop them; other threads may be writing those, so this is done only for rows whose
// neighbours are in the range too.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "film/fill_holes.cpp"
#include "base/simd.h"

#include "film/fill_holes.h"
#include "film/fill_one_hole.h"

#include <algorithm>
#include <bit>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, 16>;
using Bytes = hn::Rebind<std::uint8_t, Floats>;

template <class M>
std::uint64_t bits_of(M mask)
{
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(Floats(), mask, bytes);
    std::uint64_t word;
    std::memcpy(&word, bytes, 8);
    return word;
}

/// The lanes whose pixels are holes, as bits.
std::uint64_t holes_at(const HolePicture& picture, std::size_t at)
{
    const hn::Rebind<std::uint32_t, Floats> wide;
    const auto hole = hn::PromoteTo(wide, hn::LoadU(Bytes(), &picture.hole[at]));
    return bits_of(hn::RebindMask(Floats(), hn::Ne(hole, hn::Zero(wide))));
}

/// Fills the `wanted` lanes of the register of pixels that starts at `at` from the ring at kReach
/// around each. No wanted pixel may be nearer to the picture's edge than kReach. Returns the lanes
/// whose ring has only holes.
template <int kReach>
std::uint64_t fill_register(const HolePicture& picture, std::size_t at, std::uint64_t wanted)
{
    const Floats d;
    const hn::Rebind<std::uint32_t, Floats> wide;
    const auto none = hn::Zero(d);
    auto red = none, green = none, blue = none, weight = none;
    const auto add = [&](int dx, int dy) {
        const std::size_t pixel = at + std::size_t(dy * picture.width + dx);
        const auto hole = hn::PromoteTo(wide, hn::LoadU(Bytes(), &picture.hole[pixel]));
        const auto valid = hn::RebindMask(d, hn::Eq(hole, hn::Zero(wide)));
        auto r = none, g = none, b = none;
        hn::LoadInterleaved3(d, &picture.color[pixel * 3], r, g, b);
        const auto share = hn::Set(d, 1.0f / float(dx * dx + dy * dy));
        red = hn::Add(red, hn::IfThenElseZero(valid, hn::Mul(share, r)));
        green = hn::Add(green, hn::IfThenElseZero(valid, hn::Mul(share, g)));
        blue = hn::Add(blue, hn::IfThenElseZero(valid, hn::Mul(share, b)));
        weight = hn::Add(weight, hn::IfThenElseZero(valid, share));
    };
    for (int dy = -kReach; dy <= kReach; ++dy) // in the order of fill_one_hole
        for (int dx = -kReach; dx <= kReach; dx += dy == -kReach || dy == kReach ? 1 : 2 * kReach)
            add(dx, dy);

    // Writes the filled holes only, because other threads may be reading the pixels between them.
    alignas(64) float mean[3 * hn::MaxLanes(d)];
    hn::StoreInterleaved3(
        hn::Div(red, weight), hn::Div(green, weight), hn::Div(blue, weight), d, mean);
    const std::uint64_t filled = wanted & bits_of(hn::Gt(weight, none));
    for (std::uint64_t rest = filled; rest; rest &= rest - 1) {
        const auto k = std::size_t(std::countr_zero(rest));
        for (std::size_t c = 0; c < 3; ++c) picture.color[(at + k) * 3 + c] = mean[k * 3 + c];
    }
    return wanted & ~filled;
}

/// Fills the holes of a row. The `margin` >= 1 rows above and below it are in the range.
std::uint64_t fill_inner_row(const HolePicture& picture, int y, int margin)
{
    const int lanes = int(hn::Lanes(Floats())), width = picture.width;
    const std::size_t row = std::size_t(y) * std::size_t(width);
    std::uint64_t count = fill_one_hole(picture, 0, y, 1);
    int x = 1;
    for (; x + lanes < width; x += lanes) {
        const std::size_t at = row + std::size_t(x);
        const std::uint64_t holes = holes_at(picture, at);
        if (holes == 0) continue;
        std::uint64_t alone = fill_register<1>(picture, at, holes);
        int reach = 2;
        if (alone && margin >= 2 && x >= 2 && x + lanes + 1 < width) {
            alone = fill_register<2>(picture, at, alone);
            ++reach;
        }
        count += std::uint64_t(std::popcount(holes & ~alone));
        for (; alone; alone &= alone - 1)
            count += fill_one_hole(picture, x + std::countr_zero(alone), y, reach);
    }
    for (; x < width; ++x) count += fill_one_hole(picture, x, y, 1);
    return count;
}

std::uint64_t fill_rows(const HolePicture& picture, int first, int last)
{
    std::uint64_t count = 0;
    for (int y = first; y < last; ++y) {
        const std::uint8_t* row = &picture.hole[std::size_t(y) * std::size_t(picture.width)];
        if (!std::memchr(row, 1, std::size_t(picture.width))) continue;
        const int margin = std::min(y - first, last - 1 - y);
        if (margin > 0)
            count += fill_inner_row(picture, y, margin);
        else
            for (int x = 0; x < picture.width; ++x) count += fill_one_hole(picture, x, y, 1);
    }
    return count;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace firsthit
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firsthit {

HWY_EXPORT(fill_rows);

std::uint64_t fill_holes(const HolePicture& picture, int first, int last)
{
    return HWY_DYNAMIC_DISPATCH(fill_rows)(picture, first, last);
}

} // namespace firsthit
#endif
