// find_receivers.h - which hits have the light on the side of their surface that the eye sees, and
// how far is each moved off that surface?
#pragma once

#include "base/buffer.h"
#include "hits/hit_tile.h"
#include "irregular/mesh/pencil_mesh.h"

#include <cstdint>
#include <span>
#include <span>

namespace firsthit {

/// The samples of one block on one triangle that faces the light.
struct FacingRun {
    float receiver[4];         // away, margin (exact/shadow_ray.h)
    std::uint64_t samples = 0; // bit k: sample 64 * block + k
    std::uint32_t block = 0;
};
static_assert(sizeof(FacingRun) == 32, "two in a cache line");

/// Those of a tile, in the order of HitTile::runs; a worker's memory.
struct TileReceivers {
    Buffer<FacingRun> run;
    std::size_t count = 0;

    std::span<const FacingRun> runs() const { return run.span().first(count); }
};

/// Finds the runs of a tile whose item's plane has light and eye on the same side, exactly, and
/// neither lies in it.
void find_receivers(const PencilMesh& mesh, const HitTile& hits, TileReceivers& receivers);

} // namespace firsthit
