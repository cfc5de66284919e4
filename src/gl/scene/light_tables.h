// light_tables.h - lights and shadow maps as shaders read them.
#pragma once

#include "exact/pencil.h"
#include "gl/scene/gpu_data.h"
#include "shadow/map/shadow_map.h"

#include <firsthit/scene.h>

#include <span>
#include <vector>

namespace firsthit::gl {

/// How a picture's samples become world space, and lights' spaces.
struct SampleFrame {
    glm::vec3 eye{0};            // world space, as floats like the cpu engine's (hits/hit_tile.h)
    glm::mat3 world_from_eye{1}; // columns: right, down, forward
    float inv_f = 1;
};

SampleFrame sample_frame(const Pencil& pencil);

/// (lights) Fills in all but only_face where there are no maps yet.
/// maps  of the world's lights, or empty
void fill_lights(const World& world, const SampleFrame& frame, std::span<const ShadowLight> maps,
    std::vector<LightData>& lights);

/// (lights, kFaces). A face without a map has width 0.
/// first   (lights, kFaces) where each map's texels begin
/// filter  N: N x N texels are compared
void fill_maps(std::span<const ShadowLight> lights, const SampleFrame& frame,
    std::span<const std::uint32_t> first, int filter, std::vector<MapData>& maps);

} // namespace firsthit::gl
