// map_pencil.h - the rays of a shadow map's texels, and the transform from a point to its texel.
#pragma once

#include "exact/pencil.h"
#include "shadow/map/shadow_map.h"

#include <firsthit/scene.h>

namespace firsthit {

/// Fills in the map's matrix, origin and offset from its source, and returns the pencil of its
/// rays. The pencil's x0, y0, width and height are not set; they select the texels to rasterise. In
/// the map of a parallel light, depths are from 0 to half of the pencil's `far`.
Pencil set_map_transform(const World& world, int face, ShadowMap& map);

} // namespace firsthit
