// merge_faces.h - uses one map instead of several where a single face can see all hits.
#pragma once

#include "shadow/map/hit_bounds.h"

namespace firsthit {

/// Moves all hits to one face, if there is a face that sees all of them within kWidestTangent on
/// both axes; if there are several, to the one with the smallest rectangle. Its rectangle then
/// covers the rectangles of all faces. Most lights stand outside of what the eye sees, and one map
/// is faster than two.
void merge_faces(LightBounds& bounds);

} // namespace firsthit
