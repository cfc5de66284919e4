// find_facing.h - which hits have the light on the side of their surface that the eye sees?
#pragma once

#include "hits/hit_tile.h"
#include "visibility/light_mesh.h"

#include <cstdint>
#include <span>

namespace firsthit {

/// A bit for each sample of each block: its item's plane has light and eye on the same side,
/// exactly, and neither lies in it.
/// facing  (blocks)
void find_facing(const LightMesh& mesh, const HitTile& hits, std::span<std::uint64_t> facing);

} // namespace firsthit
