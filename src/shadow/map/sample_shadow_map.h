// sample_shadow_map.h - shadow map sampling: the visibility of a light from the hits of a tile.
#pragma once

#include "shadow/map/shadow_map.h"

namespace firsthit {

/// Writes the visibility of `light` for the tile's samples, in tile order. Percentage-closer
/// filtering: it is the fraction of the N x N texels around the hit (N = settings.shadow_filter)
/// that show no triangle in front of the hit. 0 where the light is not on the eye's side of the
/// item's plane, and outside a spot light's cone. 1 where there is no shadow ray
/// (exact/shadow_ray.h). Undefined for samples without an item. The same bits on every instruction
/// set.
///
/// A texel's triangle is in front of the hit if the texel's depth is smaller than the hit's by more
/// than epsilon:
///
///     settings.shadow_bias >= 0   epsilon = shadow_bias, a constant along the map's axis
///     else                        epsilon = 1.5 slope_bias (src/glsl/shadow_map.glsl) with a reach
///                                 of N / 2 texels, plus 2^-20 of the sizes of the rounded terms
///
/// visibility  (hits.size^2) in [0, 1]; aligned to 64 bytes
/// limits   occluders nearer than epsilon to their receiver cast no shadow; shadow edges are wrong
///          by up to a texel
/// source   Robert and Schoepke 2006, section 4.2.1; Reeves, Salesin and Cook 1987, "Rendering
///          Antialiased Shadows with Depth Maps" (N x N)
void sample_shadow_map(const ShadowMaps& maps, const World& world, const HitTile& hits,
    std::size_t light, float* visibility);

} // namespace firsthit
