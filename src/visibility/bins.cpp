// bins.cpp - triangles to the tiles that they may meet: a counting sort in three passes.
#include "visibility/bins.h"

#include "visibility/triangle_box.h"

#include <algorithm>

namespace firsthit {
namespace {

/// Triangles of one range: enough to be worth a task, few enough to share out.
constexpr std::size_t kRange = 8192;

/// Entries beyond four a triangle that are accepted at once: 400 MB.
constexpr std::uint64_t kManyEntries = std::uint64_t(1) << 25;

template <class F>
void for_tiles(const InView& box, const ViewMemory& memory, const F& f)
{
    const int tx0 = memory.tile_of[std::size_t(box.x0)], tx1 = memory.tile_of[std::size_t(box.x1)];
    const int ty0 = memory.tile_of[std::size_t(box.y0)], ty1 = memory.tile_of[std::size_t(box.y1)];
    for (int ty = ty0; ty <= ty1; ++ty)
        for (int tx = tx0; tx <= tx1; ++tx) f(tx, ty);
}

/// Pass 1: keeps the triangles in view and counts them by tile.
void count_range(std::size_t range, ViewMemory& memory)
{
    const std::size_t first = range * kRange, last = std::min(memory.index.size(), first + kRange);
    std::uint32_t* counts = &memory.cursor[range * std::size_t(memory.tiles())];
    std::fill_n(counts, memory.tiles(), 0u);
    InView* kept = &memory.in_view[first];
    for (std::size_t t = first; t < last; ++t) {
        if (!box_of(std::uint32_t(t), memory.index[t], memory, *kept)) continue;
        for_tiles(*kept, memory, [&](int tx, int ty) { ++counts[ty * memory.tiles_x + tx]; });
        ++kept;
    }
    memory.range_count[range] = std::uint32_t(kept - &memory.in_view[first]);
}

/// Pass 2: where each range's entries of each tile start. Returns the number of entries.
std::uint64_t start_tiles(std::size_t ranges, ViewMemory& memory)
{
    const std::size_t tiles = std::size_t(memory.tiles());
    std::uint64_t next = 0;
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        memory.tile_start[tile] = std::uint32_t(next);
        for (std::size_t range = 0; range < ranges; ++range) {
            std::uint32_t& cursor = memory.cursor[range * tiles + tile];
            const std::uint32_t count = cursor;
            cursor = std::uint32_t(next);
            next += count;
        }
    }
    memory.tile_start[tiles] = std::uint32_t(next);
    return next;
}

/// Pass 3: writes the entries.
void scatter_range(std::size_t range, ViewMemory& memory)
{
    std::uint32_t* cursor = &memory.cursor[range * std::size_t(memory.tiles())];
    const InView* box = &memory.in_view[range * kRange];
    const InView* end = box + memory.range_count[range];
    const int size = memory.tile_size;
    for (; box != end; ++box) {
        for_tiles(*box, memory, [&](int tx, int ty) {
            const auto local = [size](int sample, int tile) {
                return std::uint8_t(std::clamp(sample - tile * size, 0, size - 1));
            };
            memory.entry[cursor[ty * memory.tiles_x + tx]++] = {box->triangle, local(box->x0, tx),
                local(box->y0, ty), local(box->x1, tx), local(box->y1, ty), box->nearest_z};
        });
    }
}

} // namespace

bool bin_triangles(std::span<const glm::uvec3> index, ViewMemory& memory, Tasks& tasks)
{
    const std::size_t ranges = (index.size() + kRange - 1) / kRange;
    const std::size_t tiles = std::size_t(memory.tiles());
    memory.index = index;
    memory.in_view.resize(index.size());
    memory.range_count.resize(ranges);
    memory.cursor.resize(ranges * tiles);
    memory.tile_start.resize(tiles + 1);

    tasks.for_each(ranges, [&](std::size_t range, std::size_t) { count_range(range, memory); });
    memory.entry_count = start_tiles(ranges, memory);
    memory.in_view_count = 0;
    for (std::size_t range = 0; range < ranges; ++range)
        memory.in_view_count += memory.range_count[range];
    if (memory.entry_count > kManyEntries + 4 * index.size() && tiles > 1) return false;
    // Room to spare, untouched: a moving scene's entries grow and shrink from frame to frame.
    memory.entry.resize(memory.entry_count, memory.entry_count + index.size() + 64 * tiles);
    tasks.for_each(ranges, [&](std::size_t range, std::size_t) { scatter_range(range, memory); });
    return true;
}

} // namespace firsthit
