// find_receivers.h - finds the hits whose surface faces the light, and how to lift them off it.
#pragma once

#include "base/buffer.h"
#include "hits/hit_tile.h"
#include "irregular/mesh/pencil_mesh.h"

#include <cstdint>
#include <span>
#include <span>

namespace firsthit {

/// The samples of one block that lie on one triangle, which faces the light.
struct FacingRun {
    float receiver[4];         // Receiver::away, margin (exact/shadow_ray.h)
    std::uint64_t samples = 0; // bit k: sample 64 * block + k
    std::uint32_t block = 0;
};
static_assert(sizeof(FacingRun) == 32, "two in a cache line");

/// The facing runs of a tile, in the order of HitTile::runs. Each worker has one of its own.
struct TileReceivers {
    Buffer<FacingRun> run;
    std::size_t count = 0;

    std::span<const FacingRun> runs() const { return run.span().first(count); }
};

/// Finds the runs of a tile whose triangle has the light and the eye on the same side of its plane.
/// Exact; runs where the light or the eye lies in the plane are left out.
void find_receivers(const PencilMesh& mesh, const HitTile& hits, TileReceivers& receivers);

} // namespace firsthit
