// map_fit.h - the size and frustum of a shadow map.
//
// "The proper size of the shadow map has to be evaluated using the camera frustum and the type of
// the light source" (Robert and Schoepke 2006, section 3.2). Here: the map looks at what the camera
// sees of each of the light's faces, no more, and has about as many texels as there are hits on the
// face. Both are rounded, so that the map of a slowly moving camera seldom changes:
//
//     step  = the power of two in (extent / 16, extent / 8], extent = the rectangle's longer side
//     sides = the hits' rectangle, outwards to multiples of the step
//     size  = sqrt(hits * longer / shorter side), to a quarter of a power of two, 256 to 4096
#pragma once

#include "shadow/map/hit_bounds.h"

namespace firsthit {

inline constexpr int kSmallestMap = 256; // where the size follows from the hits
inline constexpr int kLargestMap = 4096;

/// A rectangle of a face's projection (see FaceBounds) and its square texels.
struct MapFit {
    double middle_x = 0;
    double middle_y = 0;
    double texel = 0; // side, in the units of the rectangle
    int width = 0;    // texels; 0: no map
    int height = 0;

    bool operator==(const MapFit&) const = default;
};

/// size    texels on the longer side; 0: by the hits
/// filter  texels beyond the hits that are looked at: half of them on each side
MapFit map_fit(const FaceBounds& bounds, int size, int filter);

} // namespace firsthit
