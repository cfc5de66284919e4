// embree_tile.h - the hits of one tile and the lights that reach them, by Embree's packets of rays.
#pragma once

#include "base/buffer.h"
#include "hits/hit_tile.h"
#include "hits/resolve_tile.h"

#include <firsthit/scene.h>

#include <embree3/rtcore.h>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

namespace firsthit {

/// Of a shadow ray's length (of a directional light: of its unit), what is left out next to the hit,
/// whose position is rounded in world space.
inline constexpr float kShadowStart = 0x1p-14f;

/// What is asked of the rays of a tile.
struct EmbreeTile {
    RTCScene scene = nullptr;
    const std::uint32_t* first_triangle = nullptr; // see EmbreeTree
    int packet = 8;                                // rays in a packet: 8, 4x2 pixels, or 16, 4x4
    int size = 64;                                 // samples on a side
    int width = 0, height = 0;                     // of its part that lies in the picture
    Rays rays;                                     // from the eye, in world space
};

/// What the side of a triangle that a light sees is found by.
struct LightSide {
    glm::vec3 v;       // directional: the way the light goes; else from the light to the eye
    bool near = false; // the way from the eye to the hit has to be added
};

/// Kept from tile to tile.
struct EmbreeTileMemory {
    Buffer<LightSide> side; // (lights)
    Buffer<std::uint64_t>
        facing; // (lights, blocks): samples whose triangle the light sees from the
                // side that the eye is on
};

/// Shoots the tile's rays from the eye: in coherent packets. Fills memory.facing.
/// returns  points into `places`
HitTile see_embree(const EmbreeTile& tile, const HitPlaces& places, std::span<const Light> lights,
    EmbreeTileMemory& memory);

/// Shoots a ray from each hit to each light that it faces, in coherent packets. Where all pixels of a
/// packet from the eye have one, they stay together; the others are packed.
/// lit      (lights, samples) 0 or 1, aligned to 64 bytes
/// returns  the number of rays
std::uint64_t find_light_visibility_embree(const EmbreeTile& tile, const HitTile& hits,
    std::span<const Light> lights, const EmbreeTileMemory& memory, float* lit);

} // namespace firsthit
