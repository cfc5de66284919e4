// pixel_steps.h - the pixels whose rays are shot when pictures are interleaved (x).
//
//     N = 2        N = 4        N = 8
//     x . x . x    x . x . x    x . . . x
//     x . x . x    . . . . .    . . . . .
//     x . x . x    x . x . x    x . . . x
#pragma once

#include <firsthit/view.h>

#include <bit>

namespace firsthit {

/// The pixels whose column is a multiple of x and whose row is a multiple of y. Both are powers of two, so
/// that the shot pixels are a picture of their own, whose rays are those of the whole one bit for bit.
struct PixelSteps {
    int x = 1;
    int y = 1;

    static constexpr int kMost = 16;

    /// Whether there are steps for one ray in `every` pixels: 1, 2, 4, 8 and 16.
    static constexpr bool is_known(int every)
    {
        return every >= 1 && every <= kMost && std::has_single_bit(unsigned(every));
    }

    /// The steps for one ray in `every` pixels, which is_known: as square as can be, and wider than high.
    static constexpr PixelSteps of(int every)
    {
        const int powers = std::bit_width(unsigned(every)) - 1;
        return {1 << (powers + 1) / 2, 1 << powers / 2};
    }

    constexpr bool all() const { return x == 1 && y == 1; }
    constexpr bool is_shot(int px, int py) const { return px % x == 0 && py % y == 0; }

    /// The shot pixels in a region of the picture, counted in steps.
    constexpr Region shot(const Region& region) const
    {
        const auto first = [](int from, int step) { return (from + step - 1) / step; };
        const int left = first(region.x, x), top = first(region.y, y);
        return {left, top, first(region.x + region.width, x) - left,
            first(region.y + region.height, y) - top};
    }
};

} // namespace firsthit
