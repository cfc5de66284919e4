// find_receivers.h - which hits have the light on the side of their surface that the eye sees, and
// how far is each moved off that surface?
#pragma once

#include "base/buffer.h"
#include "hits/hit_tile.h"
#include "visibility/light_mesh.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// The receivers (exact/shadow_ray.h) of a tile's samples, structure of arrays in tile order. Only
/// those that face the light are defined.
struct TileReceivers {
    Buffer<float> x, y, z; // away
    Buffer<float> margin;

    void resize(std::size_t samples)
    {
        for (auto* values : {&x, &y, &z, &margin}) values->resize(samples);
    }
};

/// A bit for each sample of each block: its item's plane has light and eye on the same side,
/// exactly, and neither lies in it.
/// facing  (blocks)
void find_receivers(const LightMesh& mesh, const HitTile& hits, std::span<std::uint64_t> facing,
    TileReceivers& receivers);

} // namespace firsthit
