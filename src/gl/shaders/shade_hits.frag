// shade_hits.frag - the colour of each sample. With FIRSTHIT_STORED_HITS the hits were found by
// intersect.frag, and the samples without one are masked; else all is done here, in a single pass.
//
// source  Robert and Schoepke 2006, sections 4.2.1 and 4.2.2
#include "frame.glsl"
#include "scene.glsl"
#include "intersect.glsl"
#include "items.glsl"
#include "find_hit.glsl"
#include "hit_position.glsl"
#include "spot_cone.glsl"
#include "power.glsl"
#include "texture.glsl"
#include "shadow_map.glsl"
#include "surface.glsl"
#include "materials.glsl"
#include "models.glsl"
#include "sample_texture.glsl"
#include "find_surface.glsl"
#include "lights.glsl"
#include "sample_shadow_map.glsl"
#include "shade.glsl"
#include "count_invocations.glsl"

#ifdef FIRSTHIT_STORED_HITS
layout(early_fragment_tests) in;
#endif
layout(location = 0) out vec4 color_out; // linear Rec.709, and where it is from: frame.glsl

void main()
{
    count_invocation();
    ivec2 at = ivec2(gl_FragCoord.xy);
    Hit hit = find_hit(at);
    color_out = vec4(frame.background, hit.item == kHole ? kHoleAlpha : kBackgroundAlpha);
    if (is_hit(hit)) color_out = vec4(shade(at, hit, find_surface(at, hit)), kHitAlpha);
}
