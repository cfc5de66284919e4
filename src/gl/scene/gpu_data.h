// gpu_data.h - what the gpu engine's shaders read, as it lies in buffers (std140, std430).
//
// The same structs are in gl/shaders/frame.glsl, scene.glsl and lights.glsl. A vec3 starts at a
// multiple of 16 bytes, and the number after it fills its last four.
#pragma once

#include "exact/rays.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>

namespace firsthit::gl {

/// What all samples of a part of a picture share.
struct FrameData {
    Rays rays;          // of the part's samples, in world space
    glm::vec3 shear{0}; // Pencil::shear
    std::int32_t lights = 0;
    glm::vec3 background{0};
    std::int32_t reach = 0; // neighbours on each side that are tried for a missed item
    glm::vec3 ambient{0};
    float bias = -1;                   // of maps
    glm::ivec2 size{0};                // of the part, samples
    glm::ivec2 corner{0};              // the part's first sample, in the picture
    std::uint32_t triangles = 0;       // items from here on are none
    std::int32_t interleave = 1;       // every so-many-th sample of a row is shot: hits/lattice.h
    std::int32_t interleave_shift = 0; // from row to row
    std::int32_t filter = 1;           // N: N x N texels are compared
};
static_assert(offsetof(FrameData, shear) == 64 && offsetof(FrameData, lights) == 76 &&
              offsetof(FrameData, ambient) == 96 && offsetof(FrameData, size) == 112 &&
              offsetof(FrameData, triangles) == 128 && sizeof(FrameData) == 144);


/// At most so many lights lie in uniform blocks, of which every driver has 16 KB; more in storage
/// blocks, which are slower.
inline constexpr std::size_t kFewLights = 28;

struct LightData {
    Rays to_frame; // those of (X, Y, 1) in eye space, in the axes of shadow/map/light_frame.h
    glm::vec3 color{0};
    std::int32_t kind = 0;       // Light::Kind
    glm::vec3 position{0};       // world space
    float tan2_cone = 0;         // square of a spot's tangent where its maps end; 0: no cone
    glm::vec3 to_light{0};       // directional: unit
    std::int32_t only_face = -1; // the face of all hits; -1: each hit has its own
    glm::vec3 axis{0};           // spot: unit, the way the light goes
    float outer = 0;             // spot: see hits/spot_cone.h
    glm::vec3 frame_x{1, 0, 0};  // rows of frame_from_world
    float inv_width = 0;
    glm::vec3 frame_y{0, 1, 0};
    std::int32_t cube = 0; // six faces
    glm::vec3 frame_z{0, 0, 1};
    std::int32_t unused = 0;
};
static_assert(offsetof(LightData, color) == 64 && offsetof(LightData, axis) == 112 &&
              offsetof(LightData, frame_z) == 160 && sizeof(LightData) == 176);

static_assert(kFewLights * sizeof(LightData) <= 16384);

/// One face of a light; width 0: no map.
struct MapData {
    Rays to_map;             // in (texel x, texel y, depth), the first two times the depth
    std::uint32_t first = 0; // of its texels, see shadow/map/store_depth.h
    std::int32_t width = 0;
    std::int32_t height = 0;
    float reach = 0;    // of slope_bias (src/glsl/shadow_map.glsl)
    float rounding = 0; // added to it
    std::int32_t unused[3] = {};
};
static_assert(
    offsetof(MapData, first) == 64 && offsetof(MapData, rounding) == 80 && sizeof(MapData) == 96);

} // namespace firsthit::gl
