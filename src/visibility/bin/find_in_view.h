// find_in_view.h - the triangles of a range that may hit a sample, and what the tiny ones cover.
#pragma once

#include "visibility/bin/view_memory.h"

#include <cstddef>

namespace firsthit {

/// What becomes of triangles whose box has at most 2x2 samples.
enum class TinyTriangles {
    entries, // the same as of all others
    items,   // fragments where it is certain what they cover, and how deep
    depths,  // fragments as shadow maps want them: what is not certainly missed is covered
};

/// Triangles of one range: enough to be worth a task, few enough to share out.
inline constexpr std::size_t kTriangleRange = 8192;

/// Fills in_view and found of a range, and counts both by tile in cursor and fragment_cursor.
void find_in_view(std::size_t range, TinyTriangles tiny, ViewMemory& memory);

/// Copies a range's fragments to their tiles, from where fragment_cursor says.
void scatter_fragments(std::size_t range, ViewMemory& memory);

/// Calls f(tile) for the tiles that a box meets.
template <class F>
inline void for_tiles(const InView& box, const ViewMemory& memory, const F& f)
{
    const int tx0 = memory.tile_of[std::size_t(box.x0)], tx1 = memory.tile_of[std::size_t(box.x1)];
    const int ty0 = memory.tile_of[std::size_t(box.y0)], ty1 = memory.tile_of[std::size_t(box.y1)];
    for (int ty = ty0; ty <= ty1; ++ty)
        for (int tx = tx0; tx <= tx1; ++tx) f(tx, ty);
}

} // namespace firsthit
