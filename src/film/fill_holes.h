// fill_holes.h - fills pixels that have no colour with the mean of the colours around them.
#pragma once

#include <cstdint>
#include <span>

namespace firsthit {

/// A picture with holes: pixels that have no colour yet. Row 0 is at the top.
struct HolePicture {
    int width = 0, height = 0;
    std::span<const std::uint8_t> hole; // (height, width) 1: the pixel is a hole, 0: it is not
    std::span<float> color;             // (height, width, 3)
};

/// Half the size of the largest window that is searched for colours: 33 x 33 pixels.
inline constexpr int kFillReach = 16;

/// Gives each hole in the rows [first, last) the mean colour of the pixels around it that are not
/// holes, weighted by 1 / distance^2, in the smallest window (3 x 3, 5 x 5, ...) that has such
/// pixels. A hole that is farther than kFillReach from all of them keeps its colour. The result
/// does not depend on the colours of other holes, so ranges may be filled in any order or at the
/// same time.
///
/// returns  the number of holes that were filled
/// source   Robert and Schoepke 2006, section 4.1 (interpolation of samples that were not found)
std::uint64_t fill_holes(const HolePicture& picture, int first, int last);

} // namespace firsthit
