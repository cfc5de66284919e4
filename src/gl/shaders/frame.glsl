// frame.glsl - the uniform block of values that all samples of a section share.
#include "gl/bindings.glsl"
#include "gl/layouts.glsl"

layout(std140, binding = kFrameBlock) uniform Frame { FrameData frame; };

/// Whether the ray of the sample is shot. If not, its colour is interpolated from its neighbours.
bool is_shot(ivec2 sample_at)
{
    ivec2 p = sample_at + frame.corner;
    return p.x % frame.steps.x == 0 && p.y % frame.steps.y == 0;
}

/// The direction of the sample's ray in eye space.
vec3 eye_direction(ivec2 sample_at)
{
    return vec3(frame.rays.x0 + float(sample_at.x), frame.rays.y0 + float(sample_at.y), 1.0);
}
