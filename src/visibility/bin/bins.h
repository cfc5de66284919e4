// bins.h - triangles to the tiles that they may meet.
#pragma once

#include "base/tasks.h"
#include "visibility/bin/find_in_view.h"
#include "visibility/bin/view_memory.h"

namespace firsthit {

/// Sorts the triangles by tile: fills memory.entry and memory.tile_start, memory.fragment (or
/// .depth_fragment) and memory.fragment_start from memory.corner. Conservative: a triangle that hits a
/// sample is among the entries of the sample's tile, with a box that holds the sample, or has a
/// fragment there. Their order depends on the triangles alone.
///
/// tiny     depths: only of flat corners; items: only of corners in eye space
/// returns  false, and no entries, where there would be too many for the memory: many triangles
/// that
///          each cover many tiles. Then the picture should be divided. A single tile is never
///          refused.
bool bin_triangles(std::span<const glm::uvec3> index, ViewMemory& memory, Tasks& tasks,
    TinyTriangles tiny = TinyTriangles::items);

} // namespace firsthit
