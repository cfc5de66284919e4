// opacity.h - how opaque a surface is at a point of a triangle.
#pragma once

#include <firsthit/scene.h>

#include <cstdint>

namespace firsthit {

/// The opacity of a triangle at the point with the weights u and v of corners 1 and 2: the alpha of
/// its vertices' colours, times Material::opacity, times the alpha of Material::opacity_texture,
/// always of its largest level. So the eye, lights and mirrors agree at every distance.
///
/// A pure function: it is computed in double in a fixed order without fused operations, and rounded
/// once at the end, so that it has the same bits everywhere.
///
///     value(a)  = (a0 + u (a1 - a0)) + v (a2 - a0)            alpha, s and t at the point
///     (x, y)    = TextureRef::transform times (s, t, 1)
///     (column, row) = (x width, (1 - y) height)               row 0 is at the top
///     nearest   = texel (floor(column), floor(row))
///     bilinear  = between the texels around (column - 1/2, row - 1/2), first along rows
///     opacity   = (value(alpha) opacity) alpha of the texture
///
/// Texels beyond the texture's border are those that Sampler's wrap modes put there. A texture
/// without a level is opaque.
///
/// u, v  of the exact hit, each rounded once (rounded_barycentrics in exact/hit.h)
float opacity(const Scene& scene, std::uint32_t triangle, float u, float v);

} // namespace firsthit
