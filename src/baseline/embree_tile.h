// embree_tile.h - finds the hits of one tile and the lights that reach them with Embree's packets
// of rays.
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

/// Shadow rays start at this share of the way from the hit to the light, or at this distance from
/// the hit for a directional light, since the hit's position is rounded in world space.
inline constexpr float kShadowStart = 0x1p-14f;

/// A tile whose rays are shot.
struct EmbreeTile {
    RTCScene scene = nullptr;
    const std::uint32_t* first_triangle = nullptr; // see EmbreeTree
    int packet = 8;                                // rays in a packet: 8 for 4x2 pixels, 16 for 4x4
    int size = 64;                                 // samples on a side
    int width = 0, height = 0;                     // of the part of the tile inside the picture
    Rays rays;                                     // from the eye, in world space
};

/// What decides from which side a light sees a triangle.
struct LightSide {
    glm::vec3 v;       // directional light: its direction; else: from the light to the eye
    bool near = false; // whether the vector from the eye to the hit has to be added to v
};

/// Kept from tile to tile.
struct EmbreeTileMemory {
    Buffer<LightSide> side; // (lights)
    /// (lights, blocks) a bit for each sample whose triangle the light sees from the side that the
    /// eye is on
    Buffer<std::uint64_t> facing;
};

/// Finds the hits of the tile by shooting its rays in coherent packets, and fills memory.facing.
///
/// returns  hits that lie in `places`
HitTile see_embree(const EmbreeTile& tile, const HitPlaces& places, std::span<const Light> lights,
    EmbreeTileMemory& memory);

/// Finds which lights reach the hits of a tile by shooting a ray from each hit to each light that
/// faces it, in coherent packets. The pixels of a packet from the eye stay together if all of them
/// have such a ray. The other rays are collected until they fill a packet.
///
/// memory   as see_embree left it for this tile
/// lit      (lights, samples) is filled with 0 or 1; aligned to 64 bytes
/// returns  the number of rays
std::uint64_t find_light_visibility_embree(const EmbreeTile& tile, const HitTile& hits,
    std::span<const Light> lights, const EmbreeTileMemory& memory, float* lit);

} // namespace firsthit
