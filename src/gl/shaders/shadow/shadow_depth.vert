// shadow_depth.vert - the triangles as a face of a light sees them.
#include "scene.glsl"

layout(location = 0) uniform mat3 map_from_world; // (texel x, texel y, depth); the first two times
                                                  // the depth unless `parallel`
layout(location = 1) uniform vec3 origin; // world space
layout(location = 2) uniform vec3 offset; // added after the matrix
layout(location = 3) uniform vec2 size; // of the map, texels
layout(location = 4) uniform float range; // parallel: the greatest depth; else the least
layout(location = 5) uniform bool parallel;

/// Reversed: 1 is nearest to the light. Row 0 of the map is GL's row 0.
void main()
{
    vec3 p = map_from_world * (world_position(uint(gl_VertexID)) - origin) + offset;
    if (parallel)
        gl_Position = vec4(2.0 * p.xy / size - 1.0, 1.0 - p.z / range, 1.0);
    else
        gl_Position = vec4(2.0 * p.xy / size - p.z, range, p.z);
}
