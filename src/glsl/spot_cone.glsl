// spot_cone.glsl - how much of a spot's light goes into a direction.
//
// Angles are compared by their versines, 1 - cos: the cosines of narrow cones are all nearly 1, and
// float would leave little of the difference.

/// The versine of the angle between a unit axis and d, in [0, 1]. 2 where the angle is 90 degrees
/// or more, and where d is 0, infinite or no number.
FIRSTHIT_PURE real versine(real3 axis, real3 d)
{
    // Scaled to about 1: the squares of d need not be floats.
    real largest = max(max(d.x, 0.0f - d.x), max(max(d.y, 0.0f - d.y), max(d.z, 0.0f - d.z)));
    real3 e = real3(d.x / largest, d.y / largest, d.z / largest);
    real length2 = dot(e, e);
    real along = dot(axis, e);
    real3 across = real3(axis.y * e.z - axis.z * e.y, axis.z * e.x - axis.x * e.z,
        axis.x * e.y - axis.y * e.x);
    // 1 - cos = sin^2 / (1 + cos)
    real versed = dot(across, across) / (length2 * (1.0f + along / sqrt(length2)));
    return mix(real(2.0f), versed, along > real(0.0f));
}

/// smoothstep from the cosine of the outer angle to that of the inner one. Above 0 exactly where
/// the versine is below `outer`.
///
/// outer      versine of the outer angle
/// inv_width  one over its difference to that of the inner angle, finite
FIRSTHIT_PURE real cone_share(real versine_of_d, real outer, real inv_width)
{
    real s = min(max((outer - versine_of_d) * inv_width, 0.0f), 1.0f);
    return s * s * (3.0f - 2.0f * s);
}
