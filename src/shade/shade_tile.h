// shade_tile.h - what colour is it? Materials over the hits of one tile.
#pragma once

#include "hits/hit_tile.h"
#include "hits/light_visibility.h"

#include <firsthit/scene.h>

namespace firsthit {

/// Where shading writes: linear Rec.709, tile order, 64-byte aligned, or null where nothing is
/// asked. Samples without an item get the background's colour, and 0 in the other planes.
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

/// Shades a tile by its materials' models (src/material/): what they emit, and what they reflect of
/// every light. Textures, two-sided.
/// Allocates nothing, throws nothing. The same bits for every instruction set.
///
/// The ray of sample (x, y) at depth t gives the position (see hits/hit_position.h). Both normals
/// look towards the eye, whatever the winding; the interpolated one is bent to the eye's horizon
/// where it would look beyond. A light counts where it is in front of the interpolated normal, as
/// much as `lit` and a spot's cone let through. It does not fade with distance.
///
/// hits     runs in any order of blocks; fastest where those of a block lie side by side
/// world    v = 0 is the bottom row of a texture, as in OBJ; a texture that has no levels is white
///          sound lights (scene/model/check_light.h)
/// limits   a light farther than 1e19 is not seen: the square of its distance is no float
void shade_tile(const HitTile& hits, const World& world, const LightVisibility& lit,
    const ShadeTargets& targets);

} // namespace firsthit
