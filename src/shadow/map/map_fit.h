// map_fit.h - chooses the size and frustum of a shadow map.
//
// "The proper size of the shadow map has to be evaluated using the camera frustum and the type of
// the light source" (Robert and Schoepke 2006, section 3.2). Here a map covers the hits that the
// camera sees on one of the light's faces, no more, and has about as many texels as there are hits.
// Rectangle and size are rounded, so that the map seldom changes while the camera moves slowly:
//
//     step  = the power of two in (extent / 16, extent / 8], extent = the rectangle's longer side
//     sides = the hits' rectangle, outwards to multiples of the step
//     size  = sqrt(hits * longer / shorter side), to a quarter of a power of two, 256 to 4096
#pragma once

#include "shadow/map/hit_bounds.h"

namespace firsthit {

inline constexpr int kSmallestMap = 256; // where the size follows from the hits
inline constexpr int kLargestMap = 4096;

/// The rectangle of a face (in the units of FaceBounds) that a map covers with square texels.
struct MapFit {
    double middle_x = 0;
    double middle_y = 0;
    double texel = 0; // side of a texel, in the units of the rectangle
    int width = 0;    // texels; 0: no map
    int height = 0;

    bool operator==(const MapFit&) const = default;
};

/// size    number of texels on the longer side; 0: chosen from the number of hits
/// filter  N of N x N filtering: the map is enlarged by N / 2 texels on each side
MapFit map_fit(const FaceBounds& bounds, int size, int filter);

} // namespace firsthit
