// bin_triangles.h - sorts triangles by the tiles that they may meet.
#pragma once

#include "base/tasks.h"
#include "visibility/bin/bins.h"
#include "visibility/bin/eye_mesh.h"
#include "visibility/bin/find_in_view.h"
#include "visibility/bin/tile_layout.h"

namespace firsthit {

/// Fills the bins with the triangles of the mesh. The result is conservative: a triangle that hits
/// a sample has an entry in the sample's tile, with a box that holds the sample, or it has a
/// fragment there. The order of entries and fragments depends on the triangles alone, not on
/// threads.
///
/// layout   the pencil for which the mesh was projected, divided into tiles
/// mesh     index and corners; in CornerSpace::flat if `tiny` is depths, in CornerSpace::eye if it
///          is items
/// returns  false, with bins that hold nothing usable, if many triangles each cover many tiles, so
///          that the entries would take too much memory. Then the caller divides the picture. A
///          layout with a single tile never fails
bool bin_triangles(const TileLayout& layout, const EyeMesh& mesh, Bins& bins, Tasks& tasks,
    TinyTriangles tiny = TinyTriangles::items);

} // namespace firsthit
