// light_tables.h - lights and shadow maps as shaders read them.
#pragma once

#include "exact/rays.h"
#include "gl/scene/gpu_data.h"
#include "shadow/map/shadow_map.h"

#include <firsthit/scene.h>

#include <span>
#include <vector>

namespace firsthit::gl {

/// (lights) Fills in all but only_face where there are no maps yet.
/// rays  in world space, of (X, Y, 1) in eye space: x0 = y0 = 0
/// maps  of the world's lights, or empty
void fill_lights(const World& world, const Rays& rays, std::span<const ShadowLight> maps,
    std::vector<LightData>& lights);

/// (lights, kFaces). A face without a map has width 0.
/// first   (lights, kFaces) where each map's texels begin
/// filter  N: N x N texels are compared
void fill_maps(std::span<const ShadowLight> lights, const Rays& rays,
    std::span<const std::uint32_t> first, int filter, std::vector<MapData>& maps);

} // namespace firsthit::gl
