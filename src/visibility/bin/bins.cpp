// bins.cpp - triangles to the tiles that they may meet: a counting sort in three passes.
#include "visibility/bin/bins.h"

#include <algorithm>

namespace firsthit {
namespace {

/// Entries beyond four a triangle that are accepted at once: 400 MB.
constexpr std::uint64_t kManyEntries = std::uint64_t(1) << 25;

/// Room for fragments before they are sorted: 100 MB of addresses.
constexpr std::size_t kManyFragments = std::size_t(1) << 23;

/// Pass 2: from counts (ranges, tiles) to where each range's things of each tile start. Returns the
/// number of all.
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
    // The starts move on range by range, and come back at last.
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

/// Pass 3: writes the entries.
void scatter_range(std::size_t range, ViewMemory& memory)
{
    const RangeCount count = memory.range_count[range];
    std::uint32_t* cursor = &memory.cursor[range * std::size_t(memory.tiles())];
    const InView* box = &memory.in_view[range * kTriangleRange];
    const InView* end = box + count.in_view;
    const int size = memory.tile_size;
    for (; box != end; ++box) {
        const auto place = [&](int tx, int ty, const auto& local) {
            memory.entry[cursor[ty * memory.tiles_x + tx]++] = {box->triangle, local(box->x0, tx),
                local(box->y0, ty), local(box->x1, tx), local(box->y1, ty), box->nearest_z};
        };
        const int tx = memory.tile_of[std::size_t(box->x0)];
        const int ty = memory.tile_of[std::size_t(box->y0)];
        if (box->x1 < (tx + 1) * size && box->y1 < (ty + 1) * size) [[likely]] {
            place(tx, ty,
                [size](int sample, int tile) { return std::uint8_t(sample - tile * size); });
        } else {
            for_tiles(*box, memory, [&](int x, int y) {
                place(x, y, [size](int sample, int tile) {
                    return std::uint8_t(std::clamp(sample - tile * size, 0, size - 1));
                });
            });
        }
    }
    scatter_fragments(range, memory);
}

} // namespace

bool bin_triangles(
    std::span<const glm::uvec3> index, ViewMemory& memory, Tasks& tasks, TinyTriangles tiny)
{
    const std::size_t ranges = (index.size() + kTriangleRange - 1) / kTriangleRange;
    const std::size_t tiles = std::size_t(memory.tiles());
    memory.index = index;
    memory.in_view.resize(index.size());
    memory.range_count.resize(ranges);
    memory.cursor.resize(ranges * tiles);
    memory.tile_start.resize(tiles + 1);
    // 8 a triangle for meshes up to a million, 100 MB; 2 for larger ones, whose triangles are smaller.
    // What finds no room becomes an entry.
    memory.found_room = tiny == TinyTriangles::entries
                            ? 0
                            : std::uint32_t(std::clamp<std::size_t>(
                                  kManyFragments / std::max<std::size_t>(ranges, 1),
                                  2 * kTriangleRange, 8 * kTriangleRange));
    memory.found.resize(ranges * memory.found_room);
    memory.fragment_cursor.resize(ranges * tiles);
    memory.fragment_start.resize(tiles + 1);

    tasks.for_each(
        ranges, [&](std::size_t range, std::size_t) { find_in_view(range, tiny, memory); });
    memory.entry_count = start_tiles(ranges, tiles, memory.cursor, memory.tile_start);
    const std::uint64_t fragments =
        start_tiles(ranges, tiles, memory.fragment_cursor, memory.fragment_start);
    memory.in_view_count = 0;
    for (const RangeCount& count : memory.range_count.span())
        memory.in_view_count += count.in_view + count.tiny;
    if (memory.entry_count > kManyEntries + 4 * index.size() && tiles > 1) return false;
    // Room to spare, untouched: a moving scene's entries grow and shrink from frame to frame.
    const std::size_t spare = index.size() + 64 * tiles;
    memory.entry.resize(memory.entry_count, memory.entry_count + spare);
    if (memory.corner_space == CornerSpace::eye)
        memory.fragment.resize(fragments, fragments + spare);
    else
        memory.depth_fragment.resize(fragments, fragments + spare);
    tasks.for_each(ranges, [&](std::size_t range, std::size_t) { scatter_range(range, memory); });
    return true;
}

} // namespace firsthit
