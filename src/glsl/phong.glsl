// phong.glsl - the light that a point sends to the eye.
//
// source  Phong 1975, "Illumination for Computer Generated Pictures"

/// A unit vector along d. d = 0 gives 0.
FIRSTHIT_PURE real3 unit(real3 d)
{
    real length2 = dot(d, d);
    return d * mix(real(0.0f), 1.0f / sqrt(length2), length2 > real(0.0f));
}

/// The interpolated normal n, bent just so far that the eye sees it; not unit.
FIRSTHIT_PURE real3 bend_to_eye(real3 n, real3 to_eye)
{
    return n - to_eye * min(dot(n, to_eye), 0.0f);
}

/// Whether a bent normal is one: below a millionth of a unit normal only rounding is left of its
/// direction.
FIRSTHIT_PURE truth has_direction(real3 bent)
{
    return dot(bent, bent) > real(1.0e-12f);
}

/// The unit shading normal.
///
/// n         on the eye's side of the triangle's plane (its side was chosen with the plane's)
/// geometric the plane's unit normal, towards the eye; the answer where n is 0 or points away
FIRSTHIT_PURE real3 visible_normal(real3 n, real3 geometric, real3 to_eye)
{
    real3 bent = bend_to_eye(n, to_eye);
    real inv = 1.0f / sqrt(max(dot(bent, bent), 1.0e-12f));
    return real3(mix(geometric.x, bent.x * inv, has_direction(bent)),
        mix(geometric.y, bent.y * inv, has_direction(bent)),
        mix(geometric.z, bent.z * inv, has_direction(bent)));
}

/// N.L, or 0 where the light is behind the shading normal. The triangle's plane has no say: whether
/// it faces the light changes at once from triangle to triangle, where a smooth surface should fade.
FIRSTHIT_PURE real n_dot_l(real3 n, real3 to_light)
{
    return max(dot(n, to_light), 0.0f);
}

/// (R.V)^shininess, or 0 where `cosine`, the n_dot_l of the same point, is 0.
///
/// whole  the exponent if it is whole and small (the error grows with it), else -1
FIRSTHIT_PURE real highlight(
    real3 n, real3 to_eye, real3 to_light, real cosine, int whole, real shininess)
{
    real r_v = 2.0f * cosine * dot(n, to_eye) - dot(to_light, to_eye);
    real base = min(max(r_v, 0.0f), 1.0f);
    real power = real(0.0f);
    if (whole >= 0)
        power = steady_pow_whole(base, whole);
    else
        power = steady_pow(base, shininess);
    return mix(real(0.0f), power, cosine > real(0.0f));
}

/// What one light adds.
FIRSTHIT_PURE real3 reflected(
    real3 light, real3 diffuse, real cosine, real3 specular, real specular_weight)
{
    return light * (diffuse * cosine + specular * specular_weight);
}
