// lazy_items.h - the exact items of a few samples of a picture.
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"
#include "visibility/bin/view_memory.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// A sample of a pencil: x below its width, y below its height.
struct ListedSample {
    std::uint16_t x = 0, y = 0;
};

/// Kept from call to call.
struct LazyMemory {
    Buffer<std::uint32_t> start;       // (bins + 1) into `listed`: samples by 8x8 bins, row by row
    Buffer<std::uint64_t> has_any;     // (rows of bins, words): a bit for each bin with a sample
    Buffer<std::uint32_t> order;       // (samples) by bin: number in the caller's list
    Buffer<ListedSample> listed;       // (samples) by bin
    Buffer<std::uint32_t> nearest;     // (threads, samples) by bin
    Buffer<std::uint64_t> exact_calls; // (threads)

    std::uint64_t effort = 0; // of the last call: answers by expansion arithmetic
};

/// Which triangle does each listed sample see? All triangles are streamed once past the bins that
/// hold samples; nothing is stored of them. The item is what is_hit and compare_depth (exact/hit.h)
/// name over all triangles, ties to the lowest id, kNoItem where none is hit: what raster_tile.h
/// finds, whatever the number of threads.
///
/// view     pencil, index, and corner from project_vertices
/// samples  in any order; may repeat
/// items    (samples) is filled
void find_listed_items(const ViewMemory& view, std::span<const ListedSample> samples,
    LazyMemory& memory, std::span<std::uint32_t> items, Tasks& tasks);

} // namespace firsthit
