// fill_one_hole.h - fills a single hole of a picture.
#pragma once

#include "film/fill_holes.h"

namespace firsthit {

/// Fills pixel (x, y) as fill_holes does, if it is a hole. Returns whether it was filled.
/// reach  half the size of the first window to search: 1 for 3 x 3; smaller windows have only holes
bool fill_one_hole(const HolePicture& picture, int x, int y, int reach);

} // namespace firsthit
