// collect_hits.h - from the hits of a tile to samples of a light's faces.
#pragma once

#include "hits/hit_tile.h"
#include "hits/spot_cone.h"
#include "irregular/mesh/project_points_to_face.h"
#include "shadow/exact/find_receivers.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// A tile and a light.
struct CollectWork {
    const HitTile& hits;
    std::span<const FacingRun> runs; // of the tile, see find_receivers.h
    const PencilMesh& mesh;
    const SpotCone* cone = nullptr; // of a spot, else null
    std::uint32_t first_id = 0;     // of the tile's first sample
};

/// Writes the points of the runs' samples, from sample number `first` on, to the faces that see them,
/// as project_points_to_face: the bits of hits/hit_position.h, moved by to_light and lifted off their receivers.
/// reached  (blocks) a bit for each sample of a run that is inside the cone
/// spare    room for the points of the tile
void collect_hits(const CollectWork& work, std::size_t first, std::span<IrregularSample> samples,
    std::span<std::uint64_t> reached, FacePatches& parts, PointChunk& spare);

/// The same as points.
void collect_points(const CollectWork& work, std::span<std::uint64_t> reached, PointChunk& chunk);

/// Clears the bits of the samples that are shadowed.
/// shadowed  (64 * words) 0 or 1
void remove_shadowed(const std::uint8_t* shadowed, std::span<std::uint64_t> words);

/// floats[k] = bit k of the words, 0 or 1.
void unpack_bits(std::span<const std::uint64_t> words, float* floats);

} // namespace firsthit
