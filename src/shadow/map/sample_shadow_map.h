// sample_shadow_map.h - how much of a light reaches the hits of a tile, by its shadow maps.
#pragma once

#include "shadow/map/shadow_map.h"

namespace firsthit {

/// Writes the lit fraction of `light` for the tile's samples, in tile order: the share of the N x N
/// texels around the hit (N = settings.shadow_filter) that show nothing before it. 0 where the light
/// is not on the eye's side of the item's plane, and outside of a spot's cone. 1 where there is no
/// shadow ray (exact/shadow_ray.h). Only samples with an item are defined. The same bits on every
/// instruction set.
///
/// A texel's depth counts as before the hit's where it is less by more than epsilon:
///
///     settings.shadow_bias >= 0   epsilon = shadow_bias, along the axis of the map
///     else                        epsilon = 1.5 slope_bias (src/glsl/shadow_map.glsl), with half
///                                 of N texels to reach, + 2^-20 of the numbers that were rounded
///
/// lit      (hits.size^2) aligned to 64 bytes
/// limits   what is nearer to its receiver than epsilon casts no shadow; borders are a texel wide
/// source   Robert and Schoepke 2006, section 4.2.1; Reeves, Salesin and Cook 1987, "Rendering
///          Antialiased Shadows with Depth Maps" (N x N)
void sample_shadow_map(
    const ShadowMaps& maps, const World& world, const HitTile& hits, std::size_t light, float* lit);

} // namespace firsthit
