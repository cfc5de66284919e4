// shade_tile.h - computes the colours, and other planes, of the hits of one tile.
#pragma once

#include "hits/hit_tile.h"
#include "hits/light_visibility.h"

#include <firsthit/scene.h>

namespace firsthit {

/// The arrays that shading writes, a float for each sample of the tile in tile order, aligned to 64
/// bytes. Null pointers for planes that are not wanted. Colours are linear Rec.709. Samples without
/// an item get the colour of the background, or of the environment where the scene shows it, and 0 in the
/// other planes.
struct ShadeTargets {
    /// Whether any plane is wanted.
    bool any() const { return color[0] || any_plane(); }
    /// Whether any plane but the colours is wanted.
    bool any_plane() const
    {
        return uv[0] || normal[0] || geometric_normal[0] || position[0] || albedo[0] ||
               metallic_roughness[0] || emission[0];
    }

    float* color[3] = {};
    float* uv[2] = {};
    float* normal[3] = {};
    float* geometric_normal[3] = {};
    float* position[3] = {};
    float* albedo[3] = {};
    float* metallic_roughness[2] = {};
    float* emission[3] = {};
};

/// Shades a tile by the models of its materials (src/material/): the colour is what a material
/// emits plus what it reflects of the environment, of the sky and of each light. Surfaces are two-sided and may have textures.
/// Allocates nothing and throws nothing. The same bits for every instruction set.
///
/// The position of a sample is the point of its ray at depth t (hits/hit_position.h). Both normals
/// point towards the eye, whatever the order of the corners. An interpolated normal that would
/// point away from the eye is bent until it is perpendicular to the ray. A light adds to the colour
/// if it is in front of the interpolated normal; it is multiplied by its visibility `lit` and by a
/// spot's falloff. Where `lit` is given it also fades out smoothly towards triangles that turn away from the
/// light, which are in their own shadow (terminator_share in material/surface.glsl). It fades with distance if Light::inverse_square says so.
///
/// hits     its runs may be in any order of blocks; fastest if the runs of a block are consecutive
/// world    its lights must have passed scene/model/check_light.h. v = 0 is the bottom row of a
///          texture, as in OBJ. A texture without levels is white
/// lit      the share of each light that reaches each sample; empty: all of every light. And the sky
/// limits   lights farther than 1e19 are ignored, because the square of the distance overflows
void shade_tile(const HitTile& hits, const World& world, const LightVisibility& lit,
    const ShadeTargets& targets);

} // namespace firsthit
