// item_source.h - where the items of a frame come from: our rasteriser, or a picture that OpenGL
// drew.
#pragma once

#include "base/tasks.h"
#include "visibility/bin/view_memory.h"
#include "visibility/tile_items.h"

#include <firsthit/scene.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace firsthit {

/// Finds which triangle each sample sees, for one part of the picture at a time. The same `memory`
/// is handed to all calls for a part.
class ItemSource {
  public:
    ItemSource() = default;
    ItemSource(const ItemSource&) = delete;
    ItemSource& operator=(const ItemSource&) = delete;
    virtual ~ItemSource() = default;

    /// Begins a part of the picture. Fills the mesh in eye space, and whatever else tile() needs.
    ///
    /// memory   its TileLayout is set, with the pencil of the part
    /// returns  false if the part is too large; then the caller halves it
    virtual bool start(const World& world, ViewMemory& memory, Tasks& tasks) = 0;

    /// Waits until more tiles are ready. Tiles become ready in order of their numbers, by whole
    /// rows. Called by the thread that called start().
    ///
    /// returns  the number of tiles that are ready now, more than in the call before unless all are
    virtual std::size_t wait(const ViewMemory& memory) = 0;

    /// Fills out.item, out.rays and out.counts for a tile that is ready. Items outside the part are
    /// kNoItem. Calls for different workers may overlap.
    ///
    /// out    resized to memory.tile_size
    /// holes  (blocks) 0 when called; bits are set for samples that see a triangle that was not
    ///        found, and their items are kNoItem
    virtual void tile(const ViewMemory& memory, int tile, TileItems& out,
        std::span<std::uint64_t> holes, std::size_t worker) = 0;
};

} // namespace firsthit
