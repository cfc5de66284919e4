// fill_holes.cpp - gives pixels without a colour of their own the colours around them.
//
// Most holes have a pixel beside them. Rows that have their neighbours in the range are done a
// register at a time as far as 3 x 3 windows go; what is left is done hole by hole. Registers also
// load, and drop, colours of holes, which is why the neighbours have to be the same caller's.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "film/fill_holes.cpp"
#include "base/simd.h"

#include "film/fill_holes.h"
#include "film/fill_one_hole.h"

#include <bit>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace firsthit {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, 16>;
using Bytes = hn::Rebind<std::uint8_t, Floats>;

/// Fills the holes of a register of pixels from `at` on, none of them on the picture's edge, from
/// their 3 x 3 windows. Returns the holes, and sets `alone` to those whose windows have nothing.
std::uint64_t fill_register(const HolePicture& picture, std::size_t at, std::uint64_t& alone)
{
    const Floats d;
    const auto none = hn::Zero(d);
    const auto has_color = [&](std::size_t pixel) {
        const hn::Rebind<std::uint32_t, Floats> wide;
        const auto hole = hn::PromoteTo(wide, hn::LoadU(Bytes(), &picture.hole[pixel]));
        return hn::RebindMask(d, hn::Eq(hole, hn::Zero(wide)));
    };
    auto red = none, green = none, blue = none, weight = none;
    const auto add = [&](std::size_t pixel, float share) {
        auto r = none, g = none, b = none;
        hn::LoadInterleaved3(d, &picture.color[pixel * 3], r, g, b);
        const auto valid = has_color(pixel);
        const auto s = hn::Set(d, share);
        red = hn::Add(red, hn::IfThenElseZero(valid, hn::Mul(s, r)));
        green = hn::Add(green, hn::IfThenElseZero(valid, hn::Mul(s, g)));
        blue = hn::Add(blue, hn::IfThenElseZero(valid, hn::Mul(s, b)));
        weight = hn::Add(weight, hn::IfThenElseZero(valid, s));
    };
    const std::size_t row = std::size_t(picture.width);
    add(at - row - 1, 0.5f), add(at - row, 1), add(at - row + 1, 0.5f);
    add(at - 1, 1), add(at + 1, 1);
    add(at + row - 1, 0.5f), add(at + row, 1), add(at + row + 1, 0.5f);

    auto r = none, g = none, b = none;
    hn::LoadInterleaved3(d, &picture.color[at * 3], r, g, b);
    const auto hole = hn::Not(has_color(at));
    const auto filled = hn::And(hole, hn::Gt(weight, none));
    const auto mean = [&](auto sum, auto old) {
        return hn::IfThenElse(filled, hn::Div(sum, weight), old);
    };
    hn::StoreInterleaved3(mean(red, r), mean(green, g), mean(blue, b), d, &picture.color[at * 3]);
    const auto bits = [&](auto mask) {
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(d, mask, bytes);
        std::uint64_t word;
        std::memcpy(&word, bytes, 8);
        return word;
    };
    alone = bits(hn::AndNot(filled, hole));
    return bits(hole);
}

/// Whether any of a register's pixels is a hole.
bool has_hole(const std::uint8_t* hole)
{
    return std::memchr(hole, 1, hn::Lanes(Floats())) != nullptr;
}

/// A row whose neighbours above and below are in the range.
std::uint64_t fill_inner_row(const HolePicture& picture, int y)
{
    const int lanes = int(hn::Lanes(Floats())), width = picture.width;
    const std::size_t row = std::size_t(y) * std::size_t(width);
    std::uint64_t count = fill_one_hole(picture, 0, y, 1);
    int x = 1;
    for (; x + lanes < width; x += lanes) {
        if (!has_hole(&picture.hole[row + std::size_t(x)])) continue;
        std::uint64_t alone = 0;
        const std::uint64_t holes = fill_register(picture, row + std::size_t(x), alone);
        count += std::uint64_t(std::popcount(holes & ~alone));
        for (; alone; alone &= alone - 1)
            count += fill_one_hole(picture, x + std::countr_zero(alone), y, 2);
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
        if (y > first && y + 1 < last)
            count += fill_inner_row(picture, y);
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
