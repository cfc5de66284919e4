// map_pencil.h - the rays of a shadow map's texels, and the way from a point to its texel.
#pragma once

#include "exact/pencil.h"
#include "shadow/map/shadow_map.h"

#include <firsthit/scene.h>

namespace firsthit {

/// Fills in the map's matrix, origin and offset from its source. The result's x0, y0, width and
/// height are not set: they choose the texels that are rasterised. Of a parallel light's map,
/// depths are 0 or more, and at most half of the pencil's `far`.
Pencil place_map(const World& world, int face, ShadowMap& map);

} // namespace firsthit
