// shade_hits.frag - computes the colour of each sample. With FIRSTHIT_STORED_HITS, reads the hits
// that intersect.frag stored; samples without an item are masked then. Otherwise finds the hits
// itself, so that a single pass does everything.
//
// source  Robert and Schoepke 2006, sections 4.2.1 and 4.2.2
#include "frame.glsl"
#include "scene.glsl"
#include "intersect.glsl"
#include "items.glsl"
#include "find_hit.glsl"
#include "hit_position.glsl"
#include "spot_cone.glsl"
#include "falloff.glsl"
#include "power.glsl"
#include "texture.glsl"
#include "shadow_map.glsl"
#include "surface.glsl"
#include "materials.glsl"
#include "models.glsl"
#include "environment_tables.glsl"
#include "sample_texture.glsl"
#include "find_surface.glsl"
#include "lights.glsl"
#include "sample_shadow_map.glsl"
#include "shade.glsl"
#include "count_invocations.glsl"

#ifdef FIRSTHIT_STORED_HITS
layout(early_fragment_tests) in;
#endif
layout(location = 0) out vec4 color_out; // linear Rec.709; alpha: see layouts.glsl

void main()
{
    count_invocation();
    ivec2 at = ivec2(gl_FragCoord.xy);
    Hit hit = find_hit(at);
    color_out = vec4(frame.background, hit.item == kHole ? kHoleAlpha : kBackgroundAlpha);
#if FIRSTHIT_ENVIRONMENT
    if (frame.environment_background != 0 && hit.item == kNoItem) {
        vec3 eye_d = eye_direction(at);
        Rays rays = frame.rays;
        color_out.rgb = environment_from(EnvironmentTables(0),
            ray_direction(
                eye_d.x, eye_d.y, rays.step_x, rays.step_y, rays.right, rays.down, rays.forward));
    }
#endif
    if (is_hit(hit)) color_out = vec4(shade(at, hit, find_surface(at, hit)), kHitAlpha);
}
