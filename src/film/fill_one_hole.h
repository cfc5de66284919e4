// fill_one_hole.h - the colours around one pixel.
#pragma once

#include "film/fill_holes.h"

namespace firsthit {

/// Fills pixel (x, y) as fill_holes does, if it is a hole. False where it keeps its colour.
/// reach  of the smallest window that may have a pixel, 1 for 3 x 3
bool fill_one_hole(const HolePicture& picture, int x, int y, int reach);

} // namespace firsthit
