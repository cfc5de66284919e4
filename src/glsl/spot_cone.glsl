// spot_cone.glsl - the falloff of a spot light between its inner and its outer cone.
//
// Angles are compared by their versines, 1 - cos. The cosines of small angles are all close to 1,
// so their differences would lose most digits in float.

/// The versine of the angle between a unit axis and d, in [0, 1). 2 if the angle is 90 degrees or
/// more, and if d is 0, infinite or NaN.
FIRSTHIT_PURE real versine(real3 axis, real3 d)
{
    // Scale d to about 1, because its squares could over- or underflow.
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

/// The share of the light in a direction, 0 to 1: smoothstep of the cosine, from the outer angle to
/// the inner one. Greater than 0 exactly if the versine is below `outer`.
///
/// outer      versine of the outer angle
/// inv_width  1 / (outer - versine of the inner angle), finite
FIRSTHIT_PURE real cone_share(real versine_of_d, real outer, real inv_width)
{
    real s = min(max((outer - versine_of_d) * inv_width, 0.0f), 1.0f);
    return s * s * (3.0f - 2.0f * s);
}

/// The square of what is linear in the cosine instead.
///
/// source  Khronos 2020, KHR_lights_punctual ("Inner and Outer Cone Angles")
FIRSTHIT_PURE real squared_cone_share(real versine_of_d, real outer, real inv_width)
{
    real s = min(max((outer - versine_of_d) * inv_width, 0.0f), 1.0f);
    return s * s;
}
