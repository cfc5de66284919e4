// fill_holes.h - gives pixels without a colour of their own the colours around them.
#pragma once

#include <cstdint>
#include <span>

namespace firsthit {

/// A picture with holes, row 0 at the top.
struct HolePicture {
    int width = 0, height = 0;
    std::span<const std::uint8_t> hole; // (height, width) 1: the pixel is a hole, else 0
    std::span<float> color;             // (height, width, 3)
};

/// Windows are looked at up to this many pixels from their middle: 33 x 33.
inline constexpr int kFillReach = 16;

/// Gives each hole in the rows [first, last) the mean colour of the pixels that are no holes in the
/// smallest window around it (3 x 3, 5 x 5, ...) that has any, weighted by 1 / distance^2. A hole
/// farther than kFillReach from all of them keeps its colour. No hole's colour
/// depends on another's: ranges may be filled in any order, or at once, with the same bits.
///
/// returns  the number of holes that were filled
/// source   Robert and Schoepke 2006, section 4.1 (interpolation of what is not found)
std::uint64_t fill_holes(const HolePicture& picture, int first, int last);

} // namespace firsthit
