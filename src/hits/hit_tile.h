// hit_tile.h - the exact hits of one tile of samples, while it is in cache.
#pragma once

#include "base/tile_order.h"
#include "exact/rays.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <span>

namespace firsthit {

/// The samples of one 8x8 block that see the same triangle. Each sample of a tile that has an item
/// is in exactly one run.
struct HitRun {
    std::uint32_t item = 0;
    std::uint16_t block = 0;   // number of the block in its tile; its samples start at 64 * block
    std::int16_t eye_side = 0; // 1 or -1: volume_sign (exact/hit.h) of the item in eye space
    std::uint64_t samples = 0; // bit k: sample 64 * block + k

    // A cached plane of the item in world space, which saves loading its corners. It is not exact.
    // x, y, z: the normal towards the eye, whose largest coordinate is 1 or -1. w: the height of
    // the eye above the plane, normal . (eye - p) for any p in the plane. All 0 if the plane is not
    // known.
    glm::vec4 plane{0};

    bool has_plane() const { return plane.w > 0; }
};
static_assert(sizeof(HitRun) == 32, "two in a cache line");

/// The hits of a tile in tile order (base/tile_order.h), as a structure of arrays that are each
/// aligned to 64 bytes. A sample without an item has t = +inf and u = v = 0. But t, u, v and item
/// are undefined in blocks that `covered` says to have no item at all, if HitMemory::misses is
/// false.
struct HitTile {
    int size = 64; // samples on a side
    Rays rays;     // of the samples, in world space
    std::span<const HitRun> runs;
    const std::uint64_t* covered = nullptr; // (blocks) a bit for each sample with an item; or null
    const std::uint32_t* item = nullptr;    // (size * size), or null
    const float* t = nullptr;               // depth along the view axis, world units
    const float* u = nullptr;               // weight of corner 1 (Embree's convention)
    const float* v = nullptr;               // weight of corner 2
    glm::vec2 pixel{1}; // width and height of a pixel in samples, of pictures with steps

    std::size_t blocks() const
    {
        const auto blocks_x = std::size_t(size / kBlock);
        return blocks_x * blocks_x;
    }

    /// Rays whose steps are those from pixel to pixel, for what is filtered over a pixel.
    Rays pixel_rays() const
    {
        Rays to = rays;
        to.step_x *= pixel.x;
        to.step_y *= pixel.y;
        return to;
    }

    /// Whether the block is known to have no item.
    bool is_empty(int block) const { return covered && covered[block] == 0; }
};

} // namespace firsthit
