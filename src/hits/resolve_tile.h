// resolve_tile.h - finds where exactly each sample's ray hits the triangle that the sample sees.
#pragma once

#include "base/buffer.h"
#include "exact/pencil.h"
#include "hits/hit_tile.h"
#include "visibility/bin/eye_mesh.h"
#include "visibility/tile_items.h"

namespace firsthit {

/// Where the hits of one tile are written. Each array has room for size * size elements and is
/// aligned to 64 bytes.
struct HitPlaces {
    HitRun* run = nullptr;
    std::uint64_t* covered = nullptr; // (blocks)
    std::uint32_t* item = nullptr;
    float* t = nullptr;
    float* u = nullptr;
    float* v = nullptr;
    bool items = true, misses = true; // see HitMemory
};

/// Memory for the hits of some tiles.
struct HitMemory {
    Buffer<HitRun, Pages::small> run; // (tiles, samples); a tile fills the start of its part
    Buffer<std::uint64_t> covered;    // (tiles, blocks)
    Buffer<std::uint32_t> item;       // (tiles, samples)
    Buffer<float> t, u, v;            // (tiles, samples)
    std::size_t samples = 0;          // samples of a tile

    // Writing and reading memory takes time, so what only some callers need can be left out.
    bool items = true;  // HitTile::item is filled
    bool misses = true; // t, u, v and item are also filled for blocks without any item

    HitPlaces of(std::size_t tile)
    {
        const std::size_t first = tile * samples;
        return {run.data() + first, covered.data() + first / kBlockSamples, item.data() + first,
            t.data() + first, u.data() + first, v.data() + first, items, misses};
    }
};

/// Prepares the memory for a number of tiles of tile_size x tile_size samples. Allocates only to
/// grow.
void resize(HitMemory& memory, int tile_size, std::size_t tiles);

/// Intersects the ray of each sample with the triangle that its item names, which it hits. t, u and
/// v come from one division in double that is rounded once, or from exact sums where that could
/// lose too much. t is within one unit in the last place of the exact depth, u and v are within
/// 2^-24, and HitRun::eye_side is exact, for every triangle.
///
/// mesh     in CornerSpace::eye
/// pencil   of the mesh
/// items    of a tile of the pencil; all are below the number of triangles, or kNoItem
/// returns  hits that lie in `places`
/// source   Robert and Schoepke 2006, section 4.1 (one lookup, one intersection test)
HitTile resolve_tile(
    const EyeMesh& mesh, const Pencil& pencil, const TileItems& items, const HitPlaces& places);

} // namespace firsthit
