// scatter.vert - draws a point for each sample whose item is given: see
// gl/items/certified_gpu_items.h.
#include "gl/bindings.glsl"

// The same layout as CertifiedItems::GivenItem.
struct Sample {
    uint pixel; // y << 16 | x
    uint item;
};
layout(std430, binding = kGivenItemsBlock) readonly buffer Samples { Sample samples[]; };

uniform vec2 size; // of the picture

flat out uint given;

void main()
{
    uint pixel = samples[gl_VertexID].pixel;
    vec2 middle = vec2(pixel & 0xFFFFu, pixel >> 16) + 0.5;
    given = samples[gl_VertexID].item;
    gl_Position = vec4(middle / size * 2.0 - 1.0, 0.0, 1.0);
}
