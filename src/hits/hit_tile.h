// hit_tile.h - the exact hits of one tile of samples, while it is in cache.
#pragma once

#include "base/tile_order.h"
#include "exact/rays.h"
#include "hits/block_samples.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <span>

namespace firsthit {

/// The samples of one 8x8 block that see the same triangle. All samples of a tile with an item are
/// in exactly one run.
struct HitRun {
    std::uint32_t item = 0;
    std::uint16_t block = 0;   // number of the block in its tile; its samples start at 64 * block
    std::int16_t eye_side = 0; // 1 or -1: volume_sign (exact/hit.h) of the item in eye space
    std::uint64_t samples = 0; // bit k: sample 64 * block + k

    // The item's plane in world space, for what needs no exact answer: who has it fetches no corners.
    // x, y, z: its normal towards the eye, the largest coordinate 1 or -1; w: height of the eye above it,
    // normal . (eye - p), p in the plane. All 0 where that is not known.
    glm::vec4 plane{0};

    bool has_plane() const { return plane.w > 0; }
};
static_assert(sizeof(HitRun) == 32, "two in a cache line");

/// Where the samples of a block are, where that is not a square of 8x8 in its turn.
struct BlockPlace {
    float x = 0, y = 0;                      // of its origin, in samples from the tile's first one
    const BlockSamplesXY* samples = nullptr; // from there; all are multiples of 1
};

/// Hits in tile order (see tile_order.h), structure of arrays, each aligned to 64 bytes. A sample
/// without an item has t = +inf, u = v = 0; but of a block that `covered` says to have no item at
/// all, everything is undefined (HitMemory::misses).
struct HitTile {
    int size = 64; // samples on a side
    Rays rays;     // in world space
    std::span<const HitRun> runs;
    const std::uint64_t* covered = nullptr; // (blocks) samples with an item, a bit each; or null
    const std::uint32_t* item = nullptr;    // (size * size), or null
    const float* t = nullptr;               // depth along the view axis, world units
    const float* u = nullptr;               // weight of corner 1 (Embree's convention)
    const float* v = nullptr;               // weight of corner 2

    /// Shading alone also takes packed samples (cpu/packed_tile.h): then `places` has a place for
    /// each block, and `item` is null.
    bool packed = false;
    std::span<const BlockPlace> places;

    std::size_t blocks() const
    {
        const auto blocks_x = std::size_t(size / kBlock);
        return packed ? places.size() : blocks_x * blocks_x;
    }

    /// Whether the block is known to have no item.
    bool is_empty(int block) const { return covered && covered[block] == 0; }
};

} // namespace firsthit
