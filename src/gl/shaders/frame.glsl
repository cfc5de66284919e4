// frame.glsl - what all pixels of a frame share. The layouts are those of gl/scene/gpu_data.h.

layout(std140, binding = 0) uniform Frame
{
    vec3 eye; // world space
    float inv_f;
    vec3 right; // world space
    float first_x; // ray of the part's first sample: (first_x, first_y, 1) in eye space
    vec3 down;
    float first_y;
    vec3 forward;
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

/// In eye space, x and y times f.
vec3 eye_direction(ivec2 sample_at)
{
    return vec3(frame.first_x + float(sample_at.x), frame.first_y + float(sample_at.y), 1.0);
}
