// collect_hits.h - turns the hits of a tile into samples of a light's faces.
#pragma once

#include "hits/hit_tile.h"
#include "hits/spot_cone.h"
#include "irregular/mesh/project_points_to_face.h"
#include "shadow/exact/find_receivers.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// The hits of one tile that one light may reach.
struct CollectWork {
    const HitTile& hits;
    std::span<const FacingRun> runs; // of the tile, see find_receivers.h
    const PencilMesh& mesh;
    const SpotCone* cone = nullptr; // of a spot, else null
    std::uint32_t first_id = 0;     // of the tile's first sample
};

/// Where the samples of a tile are written: to elements of `samples` from number `first` on.
struct SampleRoom {
    std::span<IrregularSample> samples;
    std::size_t first;
};

/// Projects the runs' hits onto the light's faces and writes the samples to their room, grouped by
/// face, as project_points_to_face does. Positions have the bits of hits/hit_position.h, are moved
/// by to_light, and lifted off their receivers.
///
/// reached  (blocks) receives a bit for each sample of a run that is inside the light's cone
/// patches  receives the range and bounds of each face's samples
/// spare    scratch memory with room for the points of the tile
void collect_hits(const CollectWork& work, const SampleRoom& room, std::span<std::uint64_t> reached,
    FacePatches& patches, PointChunk& spare);

/// The same positions as points of a chunk, not projected onto faces.
void collect_points(const CollectWork& work, std::span<std::uint64_t> reached, PointChunk& chunk);

/// Clears the bits of samples that are shadowed.
/// shadowed  (64 * words) 0 or 1
void remove_shadowed(const std::uint8_t* shadowed, std::span<std::uint64_t> words);

/// Writes floats[k] = bit k of the words, 0 or 1.
void unpack_bits(std::span<const std::uint64_t> words, float* floats);

} // namespace firsthit
