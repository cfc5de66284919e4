// light_tables.h - tables of lights and shadow maps for shaders.
#pragma once

#include "exact/rays.h"
#include "gl/scene/gpu_data.h"
#include "shadow/map/shadow_map.h"

#include <firsthit/scene.h>

#include <span>
#include <vector>

namespace firsthit::gl {

/// Fills the table of lights, (lights).
/// rays  the world-space rays of (X, Y, 1) in eye space: x0 = y0 = 0
/// maps  of the world's lights; or empty, then only_face is -1
void fill_lights(const World& world, const Rays& rays, std::span<const ShadowLight> maps,
    std::vector<LightData>& lights);

/// Fills the table of maps, (lights, kFaces). A face without a map has width 0.
/// first   (lights, kFaces) index of each map's first texel
/// filter  N, for N x N filtering
void fill_maps(std::span<const ShadowLight> lights, const Rays& rays,
    std::span<const std::uint32_t> first, int filter, std::vector<MapData>& maps);

} // namespace firsthit::gl
