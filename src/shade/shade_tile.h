// shade_tile.h - what colour is it? Phong's model over the hits of one tile.
#pragma once

#include "hits/hit_tile.h"

#include <firsthit/scene.h>

namespace firsthit {

/// Where shading writes: linear Rec.709, tile order, 64-byte aligned, or null where nothing is asked.
/// Samples without an item get the background's colour, and 0 in the other planes.
struct ShadeTargets {
    /// Whether anything is asked for.
    bool any() const
    {
        return color[0] || uv[0] || normal[0] || geometric_normal[0] || position[0] || albedo[0];
    }

    float* color[3] = {};
    float* uv[2] = {};
    float* normal[3] = {};
    float* geometric_normal[3] = {};
    float* position[3] = {};
    float* albedo[3] = {};
};

/// Shades a tile: ambient, diffuse and specular light of every light, textures, two-sided.
/// Allocates nothing, throws nothing. The same bits for every instruction set.
///
/// source  Phong 1975, "Illumination for Computer Generated Pictures"
void shade_tile(const HitTile& hits, const World& world, const ShadeTargets& targets);

} // namespace firsthit
