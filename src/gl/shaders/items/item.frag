// item.frag - writes the number of the triangle: see gl/items/item_pass.h. COLORS 1: as bytes of a
// colour, with the lowest byte in red.

#if COLORS
layout(location = 0) out vec4 color;
#else
layout(location = 0) out uint item;
#endif

void main()
{
    uint id = uint(gl_PrimitiveID);
#if COLORS
    color = vec4(uvec4(id, id >> 8, id >> 16, id >> 24) & 255u) / 255.0;
#else
    item = id;
#endif
}
