// item_source.h - where a frame's items come from: our rasteriser, or a buffer that OpenGL made.
#pragma once

#include "base/tasks.h"
#include "visibility/raster/item_tile.h"
#include "visibility/bin/view_memory.h"

#include <firsthit/scene.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace firsthit {

/// Answers for one part of the picture at a time: which triangle does each sample see?
class ItemSource {
  public:
    ItemSource() = default;
    ItemSource(const ItemSource&) = delete;
    ItemSource& operator=(const ItemSource&) = delete;
    virtual ~ItemSource() = default;

    /// Begins the part. memory.pencil and the tiles' numbers are set; fills memory.corner, and
    /// whatever else tile() needs. False where the part is too large: the caller halves it.
    virtual bool start(const World& world, ViewMemory& memory, Tasks& tasks) = 0;

    /// The part's tiles become ready in groups of whole rows of tiles: waits for the next group and
    /// returns the number of tiles that are ready now, all tiles in the end. Called by the thread
    /// that called start().
    virtual std::size_t wait(const ViewMemory& memory) = 0;

    /// Fills out.item of a tile that is ready, kNoItem outside the part. Calls for different workers
    /// may overlap.
    ///
    /// holes  a word for each block of the tile, 0 when called: bits are set for samples whose
    ///        triangle is not found, and their items are kNoItem
    virtual void tile(const ViewMemory& memory, int tile, ItemTile& out,
        std::span<std::uint64_t> holes, std::size_t worker) = 0;
};

} // namespace firsthit
