// item_repair.h - repairs the items of one tile of a picture that is nearly right, as OpenGL draws
// it.
#pragma once

#include "visibility/bin/eye_mesh.h"
#include "visibility/bin/tile_layout.h"
#include "visibility/tile_items.h"

#include <firsthit/options/multisample.h>

#include <cstdint>
#include <span>

namespace firsthit {

/// The number of rows and columns around a sample whose items a mode looks at: 0, 1 or 2.
constexpr int reach_of(Multisample mode)
{
    if (mode == Multisample::lazy3 || mode == Multisample::full3) return 1;
    return mode == Multisample::lazy5 || mode == Multisample::full5 ? 2 : 0;
}

/// A tile of a picture of items.
struct PictureTile {
    const TileLayout& layout; // of the picture
    /// (height, width) of layout.pencil, row 0 at the top. An id that is no triangle counts as a
    /// triangle that is missed, except kNoItem.
    std::span<const std::uint32_t> picture;
    int tile; // its number
};

/// Fills out.item, out.rays and out.counts of a tile. Tests each sample's ray (exact/hit.h) against
/// the triangle that the picture names for it. What happens next depends on the mode:
///
///   none    a sample whose ray misses the triangle is a hole
///   lazy    a sample whose ray misses takes the nearest hit among the triangles of its n x n
///           neighbourhood; if none is hit, it is a hole. Samples without an item are not tested
///   full    every sample takes the nearest hit among all triangles of its neighbourhood. If none
///           is hit, it is a hole if it had an item, and has none otherwise
///   exact   the items are right already, and are copied
///
/// The nearest hit is found exactly; of equally near triangles the one with the lowest id is taken.
///
/// mesh     in CornerSpace::eye
/// picture  rows up to reach_of(mode) above and below the tile are read
/// out      resized to the layout's tile_size; items outside the picture become kNoItem
/// holes    (blocks) 0 when called; bits are set for holes, and their items are kNoItem
/// source   Robert and Schoepke 2006, section 4.1 (lazy multisampling)
void repair_tile_items(const EyeMesh& mesh, const PictureTile& picture, Multisample mode,
    TileItems& out, std::span<std::uint64_t> holes);

} // namespace firsthit
