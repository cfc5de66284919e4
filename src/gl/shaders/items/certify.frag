// certify.frag - a sample of a polygon: see gl/items/certified_items.h.
//
// DOUBTS 0: the triangles that are hit for sure; the nearest wins, by the farthest that its hit may
//           be
// DOUBTS 1: marks samples where another triangle may be hit as near as that
#include "hit_interval.glsl"

flat in vec3 corner_a;
flat in vec3 corner_b;
flat in vec3 corner_c;
flat in uint triangle;

uniform vec2 first; // direction of the first sample

#if DOUBTS
layout(binding = 0) uniform usampler2D items;
layout(binding = 1) uniform sampler2D depths;
layout(location = 0) out uint uncertain;
#else
layout(location = 0) out uint item;
layout(location = 1) out float depth;
uniform float typical; // a depth of the scene
#endif

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    HitInterval hit = hit_interval(corner_a, corner_b, corner_c, first + vec2(pixel));
#if DOUBTS
    if (!hit.perhaps || texelFetch(items, pixel, 0).x == triangle) discard;
    if (hit.least > texelFetch(depths, pixel, 0).x) discard;
    uncertain = 1u;
#else
    if (!hit.surely) discard;
    item = triangle;
    depth = hit.most;
    gl_FragDepth = typical / (typical + hit.most); // grows towards the eye
#endif
}
