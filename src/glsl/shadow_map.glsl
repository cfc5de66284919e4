// shadow_map.glsl - the depth test of shadow maps, and its slope bias.
//
// source  Williams 1978, "Casting Curved Shadows on Curved Surfaces"; Robert and Schoepke 2006,
//         section 4.2.1 (isShadowed)

/// Whether the point is in shadow, by one texel of the map.
///
/// map_depth  depth of the triangle nearest to the light, at the texel
/// depth      depth of the point, in the same units along the same axis
/// epsilon    bias: an occluder must be nearer to the light than the point by more than this
///            (slope_bias)
FIRSTHIT_PURE truth is_shadowed_by_texel(real map_depth, real depth, real epsilon)
{
    return map_depth < depth - epsilon;
}

/// The slope bias: how much the depth of a flat receiver can change between a point and the centres
/// of the texels that are compared with it. With this bias a plane does not shadow itself. A
/// receiver that faces the light squarely has no such change; the term |n.z| of the slope then
/// still gives a bias of half the width of the texels.
///
///     light           A receiver with normal n at distance h from a point light, at depth z:
///       \                 dz/dx = z^2 n.x / h        in the units of x / z
///     ---+---+---     In parallel light:
///      \ | / | /          dz/dx = n.x / n.z
///       \|/  |/
///     ===P===C=====   |z(C) - z(P)| <= reach * z^2 (|n.x| + |n.y|) / |h|
///
/// depth           of the point; 1 in parallel light
/// receiver_slope  (|n.x| + |n.y| + |n.z|) / |h|; in parallel light (|n.x| + |n.y| + |n.z|) / |n.z|
/// reach           distance along one axis from the point to the farthest texel centre: N / 2
///                 texels
FIRSTHIT_PURE real slope_bias(real depth, real receiver_slope, real reach)
{
    return (depth * depth) * (receiver_slope * reach);
}
