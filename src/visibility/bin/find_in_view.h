// find_in_view.h - finds the triangles of a range that may hit a sample, and what tiny ones cover.
#pragma once

#include "visibility/bin/bins.h"
#include "visibility/bin/eye_mesh.h"
#include "visibility/bin/tile_layout.h"

#include <cstddef>

namespace firsthit {

/// What becomes of tiny triangles: those whose box has at most 4 x 4 samples.
enum class TinyTriangles {
    entries, // entries of their tiles, like all other triangles
    items,   // fragments, if floats are certain about the samples that they cover and the depths
    depths,  // fragments as shadow maps want them: a texel is covered unless certainly missed
};

/// Triangles in a range: enough to be worth a task, and few enough to be shared out among threads.
inline constexpr std::size_t kTriangleRange = 8192;

/// The first pass of bin_triangles: fills bins.in_view, .found and .range_count of a range, and
/// counts entries and fragments by tile in .cursor and .fragment_cursor.
void find_in_view(std::size_t range, const TileLayout& layout, const EyeMesh& mesh,
    TinyTriangles tiny, Bins& bins);

/// Copies the fragments of a range to their tiles: to the places that bins.fragment_cursor holds,
/// which move on.
///
/// tiles  number of tiles
void scatter_fragments(std::size_t range, std::size_t tiles, CornerSpace space, Bins& bins);

/// Calls f(column, row) for each tile that a box meets.
template <class F>
inline void for_tiles(const InView& box, const TileLayout& layout, const F& f)
{
    const int tx0 = layout.tile_of[std::size_t(box.x0)], tx1 = layout.tile_of[std::size_t(box.x1)];
    const int ty0 = layout.tile_of[std::size_t(box.y0)], ty1 = layout.tile_of[std::size_t(box.y1)];
    for (int ty = ty0; ty <= ty1; ++ty)
        for (int tx = tx0; tx <= tx1; ++tx) f(tx, ty);
}

} // namespace firsthit
