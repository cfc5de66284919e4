// hit_tile.h - the exact hits of one tile of samples, while it is in cache.
#pragma once

#include "base/tile_order.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

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
};

/// How samples become world space. The ray of sample (x, y) of the tile is
/// ((x0 + x) / f, (y0 + y) / f, 1) in a frame with x right, y down, z forward.
struct TileFrame {
    float x0 = 0; // of the tile's first sample; a multiple of 1/2, exact
    float y0 = 0;
    float inv_f = 1;             // 1 / f, f in samples
    glm::vec3 eye{0};            // world space
    glm::mat3 world_from_eye{1}; // columns: right, down, forward; orthonormal
};

/// Hits in tile order (see tile_order.h), structure of arrays, each aligned to 64 bytes. A sample
/// without an item has t = +inf, u = v = 0.
struct HitTile {
    int size = 64; // samples on a side
    TileFrame frame;
    std::span<const HitRun> runs;
    const std::uint32_t* item = nullptr; // (size * size)
    const float* t = nullptr;            // depth along the view axis, world units
    const float* u = nullptr;            // weight of corner 1 (Embree's convention)
    const float* v = nullptr;            // weight of corner 2
};

} // namespace firsthit
