// certify.frag - tests the ray of a sample against a triangle: see gl/items/certified_items.h.
//
// DOUBTS 0: keeps triangles that are certainly hit, which cut-outs never are; the one with the least
//           upper bound of its depth wins
// DOUBTS 1: marks samples whose ray may hit another triangle at that bound or nearer
#include "gl/bindings.glsl"
#include "hit_interval.glsl"

flat in vec3 corner_a;
flat in vec3 corner_b;
flat in vec3 corner_c;
flat in uint triangle;

uniform vec2 first; // direction of the first sample

#if DOUBTS
layout(binding = kItemsUnit) uniform usampler2D items;
layout(binding = kCertifiedDepthsUnit) uniform sampler2D depths;
layout(location = 0) out uint uncertain;
#else
layout(location = 0) out uint item;
layout(location = 1) out float depth;
uniform float typical; // a typical depth of the scene

/// Cutouts::words, least bits first.
layout(std430, binding = kCutoutsBlock) readonly buffer Cutouts { uint cutout_bits[]; };
uniform uint cutout_words; // 0: there are none

/// Whether the triangle is there only where its opacity says so, which is not asked here.
bool is_cutout()
{
    return cutout_words > 0u && (cutout_bits[triangle >> 5] >> (triangle & 31u) & 1u) != 0u;
}
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
    if (!hit.surely || is_cutout()) discard;
    item = triangle;
    depth = hit.most;
    gl_FragDepth = typical / (typical + hit.most); // grows towards the eye
#endif
}
