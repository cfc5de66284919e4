// shadow_map.glsl - is a point in the shadow of a shadow map?
//
// source  Williams 1978, "Casting Curved Shadows on Curved Surfaces"; Robert and Schoepke 2006,
//         section 4.2.1 (isShadowed)

/// map_depth  of what the light meets first, at the point's texel
/// depth      of the point, in the same units along the same axis
/// epsilon    how much nearer something has to be to count: see slope_bias
FIRSTHIT_PURE truth is_shadowed(real map_depth, real depth, real epsilon)
{
    return map_depth < depth - epsilon;
}

/// How much a receiver's depth changes at most on the way from a point to the centres of the texels
/// that are looked at for it, if the receiver is flat; where it faces the light, which would be
/// nothing, as much as half of their width. So a plane does not shadow itself.
///
///     light           a receiver with normal n and distance h from the light, or from a parallel
///       \             light's plane through the origin, seen at depth z:
///     ---+---+---     dz/dx = z^2 n.x / h        in the units of x / z
///      \ | / | /      dz/dx = n.x / n.z          where the light's rays are parallel
///       \|/  |/
///     ===P===C=====   |z(C) - z(P)| <= reach * z^2 (|n.x| + |n.y|) / |h|
///
/// depth      of the point
/// receiver_slope  (|n.x| + |n.y| + |n.z|) / |h|, or / |n.z| where the rays are parallel (depth = 1)
/// reach      from the point to the farthest texel's centre on one axis: half of N texels
FIRSTHIT_PURE real slope_bias(real depth, real receiver_slope, real reach)
{
    return (depth * depth) * (receiver_slope * reach);
}
