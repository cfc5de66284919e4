// lazy_items.h - the exact items of a few samples of a picture.
#pragma once

#include "base/buffer.h"
#include "base/tasks.h"
#include "exact/pencil.h"
#include "visibility/bin/eye_mesh.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// A sample of a pencil: x below its width, y below its height.
struct ListedSample {
    std::uint16_t x = 0, y = 0;
};

/// The memory of find_listed_items, kept from call to call.
struct LazyMemory {
    Buffer<std::uint32_t> start;       // (bins + 1) the first sample in `listed` of each bin of 8x8
                                       // samples, row by row
    Buffer<std::uint64_t> has_any;     // (rows of bins, words) a bit for each bin that has a sample
    Buffer<std::uint32_t> order;       // (samples) by bin: the sample's number in the caller's list
    Buffer<ListedSample> listed;       // (samples) by bin
    Buffer<std::uint32_t> nearest;     // (threads, samples) by bin
    Buffer<std::uint64_t> exact_calls; // (threads)
    Buffer<std::uint32_t> item;        // (samples) in the caller's order

    std::uint64_t effort = 0; // answers of the last call that took expansion arithmetic
};

/// What is asked for.
struct ListedSamples {
    std::span<const ListedSample> samples; // in any order; they may repeat
    std::span<const std::uint32_t>
        after{}; // (samples) triangles that the samples' rays hit, or empty.
                 // Then the first hit is found that comes after this one in
                 // the order of depth, then of id
};

/// Finds the triangle that each listed sample sees. Streams all triangles once past the bins that
/// hold samples, and stores nothing for them. The items are those that raster_tile finds: of all
/// triangles that is_hit (exact/hit.h) accepts and that are there (exact/cutouts.h) the nearest by compare_depth, of equally near ones
/// the one with the lowest id, kNoItem where none is hit. They do not depend on the number of
/// threads.
///
/// mesh     index and corners, in the pencil's eye space (CornerSpace::eye)
/// returns  (samples) the items. They are in the memory until the next call
std::span<const std::uint32_t> find_listed_items(const Pencil& pencil, const EyeMesh& mesh,
    const ListedSamples& listed, LazyMemory& memory, Tasks& tasks);

} // namespace firsthit
