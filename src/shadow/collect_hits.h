// collect_hits.h - from the hits of a tile to points in a light's space.
#pragma once

#include "hits/hit_tile.h"
#include "hits/spot_cone.h"
#include "visibility/see_points.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// Writes the points of the chosen samples into the chunk: the bits of hits/hit_position.h, moved
/// by to_light.
/// cone      of a spot, else null
/// first_id  of the tile's first sample
/// chosen    (blocks) a bit for each sample; all have an item. Those outside of the cone are cleared
void collect_hits(const HitTile& hits, const LightSpace& space, const SpotCone* cone,
    std::uint32_t first_id, std::uint64_t* chosen, LightChunk& chunk);

/// floats[k] = bit k of the words, 0 or 1.
void unpack_bits(std::span<const std::uint64_t> words, float* floats);

} // namespace firsthit
