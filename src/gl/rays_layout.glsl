// rays_layout.glsl - the fields of Rays (exact/rays.h) for shaders; included by layouts.glsl.

// The ray of (X, Y, 1) in eye space is at eye + t (right (X step_x) + down (Y step_y) + forward) at
// depth t. No shader is given parallel rays.
FIRSTHIT_STRUCT(Rays)
    FIRSTHIT_FIELD(vec3, eye, 0)
    FIRSTHIT_FIELD(float, step_x, 1)
    FIRSTHIT_FIELD(vec3, right, 0)
    FIRSTHIT_FIELD(float, step_y, 1)
    FIRSTHIT_FIELD(vec3, down, 0)
    FIRSTHIT_FIELD(float, x0, 0) // the first sample has X = x0, Y = y0
    FIRSTHIT_FIELD(vec3, forward, 0)
    FIRSTHIT_FIELD(float, y0, 0)
    FIRSTHIT_FIELD(int, parallel, 0)
FIRSTHIT_END(Rays)
