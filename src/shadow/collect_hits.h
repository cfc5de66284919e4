// collect_hits.h - from the hits of a tile to points in a light's space.
#pragma once

#include "hits/hit_tile.h"
#include "visibility/see_points.h"

#include <cstdint>

namespace firsthit {

/// Writes the points of the chosen samples into the chunk: the bits of hits/hit_position.h, moved
/// by to_light.
/// chosen    (blocks) a bit for each sample; all have an item
/// first_id  of the tile's first sample
void collect_hits(const HitTile& hits, const std::uint64_t* chosen, const LightSpace& space,
    std::uint32_t first_id, LightChunk& chunk);

} // namespace firsthit
