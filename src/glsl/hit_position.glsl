// hit_position.glsl - where a ray is at depth t. Whoever needs the same bits calls these.

/// The direction of the ray of (x, y, 1) in eye space, in world space (exact/rays.h). Not unit: its
/// length along the view axis is 1.
FIRSTHIT_PURE real3 ray_direction(
    real x, real y, real step_x, real step_y, real3 right, real3 down, real3 forward)
{
    return (right * (x * step_x) + down * (y * step_y)) + forward;
}

FIRSTHIT_PURE real3 hit_position(real3 eye, real3 direction, real t)
{
    return eye + direction * t;
}
