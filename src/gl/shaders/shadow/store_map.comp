// store_map.comp - converts a depth buffer to the texels of a shadow map: depths along the map's
// axis, +inf where there is no triangle, in quads of 4 x 4 (shadow/map/store_depth.h).
#include "gl/bindings.glsl"

layout(local_size_x = 4, local_size_y = 4) in;

layout(binding = kDepthUnit) uniform sampler2D reversed_depth; // see shadow_depth.vert
layout(location = kStoreSize) uniform ivec2 size; // texels
layout(location = kStoreFirst) uniform uint first; // index of the map's first texel
layout(location = kStoreRange) uniform float range; // see shadow_depth.vert
layout(location = kStoreParallel) uniform bool parallel;
layout(std430, binding = kResultBlock) writeonly buffer MapDepth { float map_depth[]; };

void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    float reversed = texelFetch(reversed_depth, min(at, size - 1), 0).x;
    float depth = parallel ? range * (1.0 - reversed) : range / reversed;
    uint quad = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    map_depth[first + quad * 16u + gl_LocalInvocationIndex] =
        reversed > 0.0 ? depth : uintBitsToFloat(0x7F800000u);
}
