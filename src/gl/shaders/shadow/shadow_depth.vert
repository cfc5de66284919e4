// shadow_depth.vert - projects a vertex onto a light's face.
#include "scene.glsl"

layout(location = kDrawMatrix) uniform mat3 map_from_world; // (texel x, texel y, depth); the first two times
                                                  // the depth unless `parallel`
layout(location = kDrawOrigin) uniform vec3 origin; // world space
layout(location = kDrawOffset) uniform vec3 offset; // added after the multiplication with the matrix
layout(location = kDrawSize) uniform vec2 size; // of the map, texels
layout(location = kDrawRange) uniform float range; // parallel: the greatest depth; else the least
layout(location = kDrawParallel) uniform bool parallel;

/// Depths are reversed: 1 is nearest to the light. Row 0 of the map is OpenGL's row 0.
void main()
{
    vec3 p = map_from_world * (world_position(uint(gl_VertexID)) - origin) + offset;
    if (parallel)
        gl_Position = vec4(2.0 * p.xy / size - 1.0, 1.0 - p.z / range, 1.0);
    else
        gl_Position = vec4(2.0 * p.xy / size - p.z, range, p.z);
}
