// bin_triangles.cpp - sorts triangles by the tiles that they may meet: a counting sort in three
// passes.
//
// The first pass finds the triangles in view and counts them by range and tile, the second one sums
// the counts up to the places where the entries of each range and tile start, and the third one
// writes the entries. Fragments are sorted in the same passes.
#include "visibility/bin/bin_triangles.h"

#include <algorithm>

namespace firsthit {
namespace {

/// So many entries are accepted in addition to four for each triangle: 400 MB.
constexpr std::uint64_t kManyEntries = std::uint64_t(1) << 25;

/// Room for the fragments of all ranges before they are sorted: 100 MB of addresses, of which only
/// those that are used take memory.
constexpr std::size_t kManyFragments = std::size_t(1) << 23;

/// Pass 2 for entries or for fragments. Returns their number.
///
/// cursor  (ranges, tiles) counts; they become the places where each range's part of each tile
///         starts
/// start   (tiles + 1) is filled with the place where each tile starts, and with the number of all
std::uint64_t start_tiles(std::size_t ranges, std::size_t tiles, Buffer<std::uint32_t>& cursor,
    Buffer<std::uint32_t>& start)
{
    std::uint32_t* sum = start.data();
    std::fill_n(sum, tiles + 1, 0u);
    std::uint64_t total = 0;
    for (std::size_t range = 0; range < ranges; ++range) {
        const std::uint32_t* count = &cursor[range * tiles];
        for (std::size_t tile = 0; tile < tiles; ++tile) sum[tile] += count[tile];
    }
    for (std::size_t tile = 0; tile <= tiles; ++tile) {
        const std::uint32_t count = sum[tile];
        sum[tile] = std::uint32_t(total);
        total += count;
    }
    // Each range moves the starts on by its counts; afterwards each start is that of the next tile.
    for (std::size_t range = 0; range < ranges; ++range) {
        std::uint32_t* at = &cursor[range * tiles];
        for (std::size_t tile = 0; tile < tiles; ++tile) {
            const std::uint32_t count = at[tile];
            at[tile] = sum[tile];
            sum[tile] += count;
        }
    }
    for (std::size_t tile = tiles; tile > 0; --tile) sum[tile] = sum[tile - 1];
    sum[0] = 0;
    return total;
}

/// Pass 3: writes the entries and the fragments of a range.
void scatter_range(std::size_t range, const TileLayout& layout, CornerSpace space, Bins& bins)
{
    const RangeCount count = bins.range_count[range];
    std::uint32_t* cursor = &bins.cursor[range * std::size_t(layout.tiles())];
    const InView* box = &bins.in_view[range * kTriangleRange];
    const InView* end = box + count.in_view;
    const int size = layout.tile_size;
    for (; box != end; ++box) {
        const auto place = [&](int tx, int ty, const auto& local) {
            bins.entry[cursor[ty * layout.tiles_x + tx]++] = {box->triangle, local(box->x0, tx),
                local(box->y0, ty), local(box->x1, tx), local(box->y1, ty), box->nearest_z};
        };
        const int tx = layout.tile_of[std::size_t(box->x0)];
        const int ty = layout.tile_of[std::size_t(box->y0)];
        if (box->x1 < (tx + 1) * size && box->y1 < (ty + 1) * size) [[likely]] {
            place(tx, ty,
                [size](int sample, int tile) { return std::uint8_t(sample - tile * size); });
        } else {
            for_tiles(*box, layout, [&](int x, int y) {
                place(x, y, [size](int sample, int tile) {
                    return std::uint8_t(std::clamp(sample - tile * size, 0, size - 1));
                });
            });
        }
    }
    scatter_fragments(range, std::size_t(layout.tiles()), space, bins);
}

} // namespace

bool bin_triangles(
    const TileLayout& layout, const EyeMesh& mesh, Bins& bins, Tasks& tasks, TinyTriangles tiny)
{
    const std::size_t triangles = mesh.index.size();
    const std::size_t ranges = (triangles + kTriangleRange - 1) / kTriangleRange;
    const std::size_t tiles = std::size_t(layout.tiles());
    bins.in_view.resize(triangles);
    bins.range_count.resize(ranges);
    bins.cursor.resize(ranges * tiles);
    bins.tile_start.resize(tiles + 1);
    // Room for 8 fragments a triangle in meshes of up to a million triangles, which is 100 MB, and
    // for 2 in larger ones, whose triangles are smaller. A triangle whose fragments find no room
    // becomes an entry.
    bins.found_room = tiny == TinyTriangles::entries
                          ? 0
                          : std::uint32_t(std::clamp<std::size_t>(
                                kManyFragments / std::max<std::size_t>(ranges, 1),
                                2 * kTriangleRange, 8 * kTriangleRange));
    bins.found.resize(ranges * bins.found_room);
    bins.fragment_cursor.resize(ranges * tiles);
    bins.fragment_start.resize(tiles + 1);

    tasks.for_each(ranges,
        [&](std::size_t range, std::size_t) { find_in_view(range, layout, mesh, tiny, bins); });
    bins.entry_count = start_tiles(ranges, tiles, bins.cursor, bins.tile_start);
    const std::uint64_t fragments =
        start_tiles(ranges, tiles, bins.fragment_cursor, bins.fragment_start);
    bins.in_view_count = 0;
    for (const RangeCount& count : bins.range_count.span())
        bins.in_view_count += count.in_view + count.tiny;
    if (bins.entry_count > kManyEntries + 4 * triangles && tiles > 1) return false;
    // Spare room, which takes no memory until it is used: the entries of a moving scene grow and
    // shrink from frame to frame.
    const std::size_t spare = triangles + 64 * tiles;
    bins.entry.resize(bins.entry_count, bins.entry_count + spare);
    if (mesh.corner_space == CornerSpace::eye)
        bins.fragment.resize(fragments, fragments + spare);
    else
        bins.depth_fragment.resize(fragments, fragments + spare);
    tasks.for_each(ranges, [&](std::size_t range, std::size_t) {
        scatter_range(range, layout, mesh.corner_space, bins);
    });
    return true;
}

} // namespace firsthit
