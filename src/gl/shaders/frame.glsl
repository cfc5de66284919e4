// frame.glsl - what all pixels of a frame share. The layouts are those of gl/scene/gpu_data.h.

/// The ray of (X, Y, 1) in eye space is at eye + t (right (X step_x) + down (Y step_y) + forward) at
/// depth t: exact/rays.h.
struct Rays {
    vec3 eye;
    float step_x;
    vec3 right;
    float step_y;
    vec3 down;
    float x0; // the first sample has X = x0, Y = y0
    vec3 forward;
    float y0;
};

layout(std140, binding = 0) uniform Frame
{
    Rays rays; // of the part's samples, in world space
    vec3 shear; // in the camera's frame, down is (shear.x, 1, 0) and forward is (shear.y, shear.z, 1)
    int lights;
    vec3 background;
    int reach; // neighbours on each side that are tried for a missed item
    vec3 ambient;
    float bias; // of maps
    ivec2 size; // of the part, samples
    ivec2 corner; // the part's first sample, in the picture
    uint triangles; // items from here on are none
    int interleave; // every so-many-th sample of a row is shot: hits/lattice.h
    int interleave_shift; // from row to row
    int filter_size; // N: N x N texels are compared
} frame;

/// The alpha of a sample says where its colour is from.
const float kHoleAlpha = 0.0; // nowhere: its triangle was not found, or it was not shot
const float kFilledAlpha = 0.25; // the colours around it
const float kBackgroundAlpha = 0.5;
const float kHitAlpha = 1.0;

/// Whether the sample's ray is shot, or its colour comes from its neighbours.
bool is_shot(ivec2 sample_at)
{
    ivec2 p = sample_at + frame.corner;
    return (p.x + p.y * frame.interleave_shift) % frame.interleave == 0;
}

/// In eye space.
vec3 eye_direction(ivec2 sample_at)
{
    return vec3(frame.rays.x0 + float(sample_at.x), frame.rays.y0 + float(sample_at.y), 1.0);
}
