// hit_position.glsl - where a ray is at depth t. Whoever needs the same bits calls these.

/// The direction (x / f, y / f, 1) of sample (x, y) in world space, not unit: its length along the
/// view axis is 1.
FIRSTHIT_PURE real3 ray_direction(
    real x, real y, real inv_f, real3 right, real3 down, real3 forward)
{
    return (right * (x * inv_f) + down * (y * inv_f)) + forward;
}

FIRSTHIT_PURE real3 hit_position(real3 eye, real3 direction, real t)
{
    return eye + direction * t;
}
