// view_memory.h - the memory that an engine keeps for the triangles of one pencil.
#pragma once

#include "visibility/bin/bins.h"
#include "visibility/bin/eye_mesh.h"
#include "visibility/bin/tile_layout.h"

namespace firsthit {

/// Owns what a pencil's triangles become, from frame to frame. Functions take only the parts that
/// they need: the layout of tiles, the mesh in eye space, the bins.
struct ViewMemory : TileLayout, EyeMesh, Bins {};

} // namespace firsthit
