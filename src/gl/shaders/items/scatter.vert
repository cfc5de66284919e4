// scatter.vert - a point for each sample whose item is given: see gl/items/certified_gpu_items.h.

struct Sample {
    uint place; // y << 16 | x
    uint item;
};
layout(std430, binding = 0) readonly buffer Samples { Sample samples[]; };

uniform vec2 size; // of the picture

flat out uint given;

void main()
{
    uint place = samples[gl_VertexID].place;
    vec2 middle = vec2(place & 0xFFFFu, place >> 16) + 0.5;
    given = samples[gl_VertexID].item;
    gl_Position = vec4(middle / size * 2.0 - 1.0, 0.0, 1.0);
}
