// intersect.frag - intersects the ray of each sample with the triangle of its item; skips the
// samples that early_z.frag masked.
#include "frame.glsl"
#include "scene.glsl"
#include "intersect.glsl"
#include "items.glsl"
#include "find_hit.glsl"
#include "hit_texels.glsl"
#include "count_invocations.glsl"

layout(early_fragment_tests) in;
layout(location = 0) out uvec4 hit_out;

void main()
{
    count_invocation();
    hit_out = hit_texel(find_hit(ivec2(gl_FragCoord.xy)));
}
