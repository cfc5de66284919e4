// merge_faces.h - one map instead of several, where it can see all hits.
#pragma once

#include "shadow/map/hit_bounds.h"

namespace firsthit {

/// Moves all hits to one face, where there is one from which none is beyond kWidestTangent on
/// either axis: the one with the smallest rectangle. Its rectangle then holds the rectangles of all
/// faces. Most lights stand outside of what is seen, and one map is faster than two.
void merge_faces(LightBounds& bounds);

} // namespace firsthit
