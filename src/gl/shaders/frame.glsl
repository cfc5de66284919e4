// frame.glsl - what all pixels of a frame share.
#include "gl/layouts.glsl"

layout(std140, binding = 0) uniform Frame { FrameData frame; };

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
