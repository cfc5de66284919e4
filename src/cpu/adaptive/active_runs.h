// active_runs.h - the parts of a picture in which something is seen, or next to which.
#pragma once

#include "base/tasks.h"
#include "base/tile_order.h"
#include "cpu/adaptive/edge_memory.h"

#include <firsthit/view.h>

#include <algorithm>
#include <cstddef>

namespace firsthit {

/// Pixels [begin, end) of the rows [top, bottom), from the region's first pixel; whole blocks.
struct PixelRun {
    int begin, end, top, bottom;
};

/// Calls f(run, worker) for runs of blocks that hold all pixels that see a triangle, and all their
/// neighbours.
///
/// all  whether to take the whole picture instead
template <class F>
void for_active_runs(
    Tasks& tasks, const EdgeSight& sight, const Region& region, bool all, const F& f)
{
    const int columns = (region.width + kBlock - 1) / kBlock;
    const int rows = (region.height + kBlock - 1) / kBlock;
    const auto is_active = [&](int bx, int by) {
        for (int y = std::max(by - 1, 0); y <= std::min(by + 1, rows - 1); ++y)
            for (int x = std::max(bx - 1, 0); x <= std::min(bx + 1, columns - 1); ++x)
                if (sight.block[std::size_t(y * columns + x)].most_w > 0) return true;
        return all;
    };
    tasks.for_each(std::size_t(rows), [&](std::size_t row, std::size_t worker) {
        const int by = int(row);
        for (int bx = 0; bx < columns;) {
            if (!is_active(bx, by)) {
                ++bx;
                continue;
            }
            int end = bx + 1;
            while (end < columns && is_active(end, by)) ++end;
            f(PixelRun{bx * kBlock, std::min(end * kBlock, region.width), by * kBlock,
                  std::min((by + 1) * kBlock, region.height)},
                worker);
            bx = end;
        }
    });
}

} // namespace firsthit
