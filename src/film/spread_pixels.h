// spread_pixels.h - makes a picture of which only every few pixels are known.
#pragma once

#include "base/pixel_steps.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// A picture of which some pixels are known: those of `steps` in a region.
struct SpreadPicture {
    PixelSteps steps;
    Region region;                // of the whole picture's pixels, not empty
    std::span<const float> known; // (shot height, shot width, 3) of steps.shot(region)
    std::span<float> color;       // (height, width, 3) of the region
};

/// Makes the rows [first, last) of the region: known pixels are copied, and each of the others becomes the
/// mean of the known pixels in the smallest window around it (3 x 3, 5 x 5, ...) that has some, weighted
/// by 1 / distance^2, with the bits of fill_holes (film/fill_holes.h). Where the region has no known
/// pixel, nothing is written.
///
/// returns  the number of pixels that are not known and were made
/// source   Robert and Schoepke 2006, section 4.1 (interleaved rendering)
std::uint64_t spread_pixels(const SpreadPicture& picture, int first, int last);

/// Copies the known pixels of the rows [first, last) to their places, and leaves the others.
void place_pixels(const SpreadPicture& picture, int first, int last);

} // namespace firsthit
