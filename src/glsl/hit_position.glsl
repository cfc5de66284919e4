// hit_position.glsl - the point of a ray at depth t. All code that needs the same bits calls these.

/// How far the ray of sample (x, y) is off the view axis, at depth 1 or, of parallel rays, at all depths;
/// world space (exact/rays.h).
FIRSTHIT_PURE real3 ray_offset(real x, real y, real step_x, real step_y, real3 right, real3 down)
{
    return right * (x * step_x) + down * (y * step_y);
}

/// The world-space direction of the ray that has direction (x, y, 1) in eye space (exact/rays.h).
/// Not unit: its component along the view axis is 1.
FIRSTHIT_PURE real3 ray_direction(
    real x, real y, real step_x, real step_y, real3 right, real3 down, real3 forward)
{
    return ray_offset(x, y, step_x, step_y, right, down) + forward;
}

/// The point at depth t, world space. Of parallel rays, `eye` is where the ray starts and `direction` is
/// forward.
FIRSTHIT_PURE real3 hit_position(real3 eye, real3 direction, real t)
{
    return eye + direction * t;
}
