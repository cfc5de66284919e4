// item_repair.h - repairs a tile of an item picture that is only nearly right.
#pragma once

#include "visibility/raster/item_tile.h"
#include "visibility/bin/view_memory.h"

#include <firsthit/options/multisample.h>

#include <cstdint>
#include <span>

namespace firsthit {

/// So many rows and columns around a tile are looked at: 0, 1 or 2.
constexpr int reach_of(Multisample mode)
{
    if (mode == Multisample::lazy3 || mode == Multisample::full3) return 1;
    return mode == Multisample::lazy5 || mode == Multisample::full5 ? 2 : 0;
}

/// Fills out.item, out.x0 and out.y0 of a tile from a picture of triangle ids, testing each
/// sample's ray against the triangle that the picture names (exact/hit.h):
///
///   none    a sample whose triangle is missed is a hole
///   lazy    there the nearest hit among the triangles of the n x n neighbourhood is taken; nothing
///           hit: a hole. Samples without an item shoot no ray
///   full    every sample takes the nearest hit among all triangles of its neighbourhood; nothing
///           hit: a hole, or none where it had no item
///   exact   the items are right already, and are copied
///
/// Nearest is exact, ties go to the lowest id. Every id from the number of triangles on, other than
/// kNoItem, is a triangle that is missed. out.counts.effort is set to this tile's.
///
/// view     pencil, tile layout, index and corner
/// picture  (height, width) of the pencil, row 0 at the top; rows up to reach_of(mode) above and
///          below the tile are read
/// out      resized to view.tile_size (raster_tile.h); out.item outside the picture is kNoItem
/// holes    a word for each block of the tile, 0 when called: bits are set for holes, and their
///          items are kNoItem
/// source   Robert and Schoepke 2006, section 4.1 (lazy multisampling)
void repair_tile_items(const ViewMemory& view, std::span<const std::uint32_t> picture, int tile,
    Multisample mode, ItemTile& out, std::span<std::uint64_t> holes);

} // namespace firsthit
