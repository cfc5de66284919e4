// lattice.h - the pixels whose rays are shot when pictures are interleaved (x).
//
//     N = 2    N = 3     N = 5
//     x . x .  x . . x   x . . . . x
//     . x . x  . . x .   . . . x . .
//     x . x .  . x . .   . x . . . .
#pragma once

#include "base/tile_order.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace firsthit {

/// Every N-th pixel of each row, shifted from row to row. The shift is the one for which the
/// nearest neighbours in the lattice are farthest apart, so that every pixel is close to a pixel of
/// the lattice.
class Lattice {
  public:
    static constexpr int kMost = 16;

    /// every  N, from 1 to kMost
    explicit constexpr Lattice(int every) : every_(every), shift_(best_shift(every))
    {
        for (int phase = 0; phase < every; ++phase)
            for (int k = 0; k < kBlockSamples; ++k)
                if ((phase + block_x(k) + shift_ * block_y(k)) % every == 0)
                    shot_[std::size_t(phase)] |= std::uint64_t(1) << k;
    }

    /// A bit for each of the 8x8 pixels from (x, y) of the picture on that is in the lattice, in
    /// the order of base/tile_order.h. x and y are at least 0.
    constexpr std::uint64_t shot(int x, int y) const { return shot_[std::size_t(phase(x, y))]; }

    /// The column 0 to N - 1 for which (column, 0) lies like (x, y) in the lattice.
    constexpr int phase(int x, int y) const { return (x + shift_ * y) % every_; }

    /// Pixel (x, y) of the picture is in the lattice if (x + shift() y) % N = 0.
    constexpr int shift() const { return shift_; }

  private:
    static constexpr int best_shift(int every)
    {
        int best = 0, farthest = 0;
        for (int shift = 0; shift < every; ++shift) {
            int nearest = every * every; // squared distance of the nearest neighbours; N^2 in a row
            for (int y = 1; y < every; ++y) {
                const int x = shift * y % every;
                const int across = std::min(x, every - x);
                nearest = std::min(nearest, across * across + y * y);
            }
            if (nearest > farthest) farthest = nearest, best = shift;
        }
        return best;
    }

    int every_, shift_;
    std::array<std::uint64_t, kMost> shot_{};
};

} // namespace firsthit
