// store_map.comp - from a depth buffer to the texels of a shadow map: depth along the map's axis,
// +inf where nothing is, in quads of 4 x 4 (shadow/map/store_depth.h).

layout(local_size_x = 4, local_size_y = 4) in;

layout(binding = 4) uniform sampler2D reversed_depth; // see shadow_depth.vert
layout(location = 0) uniform ivec2 size; // texels
layout(location = 1) uniform uint first; // of the map's texels
layout(location = 2) uniform float range; // see shadow_depth.vert
layout(location = 3) uniform bool parallel;
layout(std430, binding = 0) writeonly buffer MapDepth { float map_depth[]; };

void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    float reversed = texelFetch(reversed_depth, min(at, size - 1), 0).x;
    float depth = parallel ? range * (1.0 - reversed) : range / reversed;
    uint quad = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    map_depth[first + quad * 16u + gl_LocalInvocationIndex] =
        reversed > 0.0 ? depth : uintBitsToFloat(0x7F800000u);
}
