// resolve_tile.h - where exactly does each sample's ray hit its item?
#pragma once

#include "base/buffer.h"
#include "hits/hit_tile.h"
#include "visibility/raster/item_tile.h"
#include "visibility/bin/view_memory.h"

namespace firsthit {

/// Where the hits of one tile go: room for size * size of each, aligned to 64 bytes.
struct HitPlaces {
    HitRun* run = nullptr;
    std::uint64_t* covered = nullptr; // (blocks)
    std::uint32_t* item = nullptr;
    float* t = nullptr;
    float* u = nullptr;
    float* v = nullptr;
    bool items = true, misses = true; // see HitMemory
};

/// Room for the hits of some tiles.
struct HitMemory {
    Buffer<HitRun, Pages::small> run; // (tiles, samples); a tile fills the start of its part
    Buffer<std::uint64_t> covered;    // (tiles, blocks)
    Buffer<std::uint32_t> item;
    Buffer<float> t, u, v;   // (tiles, samples)
    std::size_t samples = 0; // of a tile

    // What few ask for takes memory's time to write and to read.
    bool items = true;  // HitTile::item is there
    bool misses = true; // of blocks without any item, t, u, v and item are written too

    HitPlaces of(std::size_t tile)
    {
        const std::size_t first = tile * samples;
        return {run.data() + first, covered.data() + first / kBlockSamples, item.data() + first,
            t.data() + first, u.data() + first, v.data() + first, items, misses};
    }
};

/// Prepares the memory; allocates where there are more or larger tiles than before.
void resize(HitMemory& memory, int tile_size, std::size_t tiles);

/// Shoots one ray per sample at the triangle that the item buffer names, which it hits. t, u and v come from
/// one division in double, rounded once, or where that could lose too much from exact sums: t is within one
/// unit in the last place of the exact depth, u and v are within 2^-24, and eye_side is exact,
/// whatever the triangle.
/// The result points into `places`.
///
/// source  Robert and Schoepke 2006, section 4.1 (one lookup, one intersection test)
HitTile resolve_tile(const ViewMemory& view, const ItemTile& items, const HitPlaces& places);

} // namespace firsthit
